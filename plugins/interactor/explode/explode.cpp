/// Hands for splitter.explode: a part under the pointer comes out and goes back when the pointer leaves, a click keeps it out, a drag slides
/// it along its way. Li, Agrawala, Curless, Salesin, Automated Generation of Interactive 3D Exploded View Diagrams, SIGGRAPH 2008, section 5.
///
/// Keys: E takes all apart or puts all together, Shift+E puts back what was kept out. With Shift or Ctrl, and beside the surface, drags are
/// the camera's.

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <lumen/components.h>
#include <lumen/interactor.h>

namespace {

using namespace lumen;

struct Explode : Interactor {
  explicit Explode(Binding& binding) : Interactor(binding) {
    if (!splitter->empty()) attach_all();
  }

  Property<Reference> splitter{this, "splitter", {}, {.doc = "the splitter.explode whose parts it moves", .accepts = "splitter", .affects = Affects::nothing}};
  Property<bool> riffle{this, "riffle", true, {.doc = "the part under the pointer comes out for as long as the pointer is there", .affects = Affects::nothing}};
  Property<float> duration{this, "duration", 0.4f, {.min = 0, .max = 10, .unit = "seconds", .doc = "from in place to all the way out", .affects = Affects::nothing}};
  Property<std::vector<float>> riffled{this, "riffled", {}, {.min = 0, .max = 1, .doc = "how far each part is out for the pointer, by number", .advanced = true, .affects = Affects::nothing}};
  // These are the splitter's, by links that the interactor makes.
  Property<float> degree{this, "degree", 0.0f, {.min = 0, .max = 1, .doc = "the splitter's", .advanced = true, .affects = Affects::nothing}};
  Property<std::vector<float>> pulled{this, "pulled", {}, {.min = 0, .max = 1, .doc = "the splitter's", .advanced = true, .affects = Affects::nothing}};
  Property<std::vector<float>> ways{this, "ways", {}, {.unit = "world", .doc = "the splitter's", .advanced = true, .affects = Affects::nothing}};
  Property<std::string> group_by{this, "group_by", {}, {.doc = "the splitter's", .advanced = true, .affects = Affects::nothing}};
  Property<Reference> hand{this, "hand", {id()}, {.doc = "the splitter's, which knows the pointer by it", .accepts = "interactor", .advanced = true, .affects = Affects::nothing}};

  void changed(std::string_view property) override {
    if (property == "splitter") attach_all();
    // The splitter's, by the link: it now knows its hand.
    if (property == "hand" && !splitter->empty() && hand->id != id()) hand.set({id()});
  }

  bool input(const InputEvent& event, ViewInput& view) override {
    if (splitter->empty()) return false;
    switch (event.type) {
      case InputEvent::Type::press: return press(event, view);
      case InputEvent::Type::move:
        if (held_) drag(event, view);
        else hover(event.position, view);
        return held_.has_value();
      case InputEvent::Type::release: return release();
      case InputEvent::Type::key: return key(event, view);
      case InputEvent::Type::click: case InputEvent::Type::double_click: case InputEvent::Type::wheel: return false;
    }
    return false;
  }

  void tick(ViewInput& view) override {
    const float step = view.reduced_motion() || !(duration > 0) ? 1.0f : float(view.time() - last_tick_) / duration;
    last_tick_ = view.time();
    const bool riffling = ease_riffled(step), turning = ease_degree(step);
    if (riffling || turning) view.animate();
    else moving_ = false;
  }

 private:
  struct Held {
    int part;
    glm::vec2 position;      ///< of the press, pixels
    glm::vec2 way;           ///< of the part from in place to all the way out, pixels
    float degree;            ///< of the part, at the press
    bool dragged = false;
  };
  static constexpr float click_pixels = 3, shortest_way = 8, linger_pixels = 12;

  void attach(PropertyBase& property, const char* of) {
    if (splitter->empty()) property.unlink();
    else property.link(splitter->id + of);
  }

  void attach_all() {
    attach(degree, ".degree");
    attach(pulled, ".pulled");
    attach(ways, ".ways");
    attach(group_by, ".group_by");
    attach(hand, ".hand");
  }

  static float at(const std::vector<float>& list, int number) { return std::size_t(number) < list.size() ? list[std::size_t(number)] : 0.0f; }
  static std::vector<float> with(std::vector<float> list, int number, float value) {
    if (list.size() <= std::size_t(number)) list.resize(std::size_t(number) + 1, 0.0f);
    list[std::size_t(number)] = value;
    while (!list.empty() && list.back() == 0) list.pop_back();
    return list;
  }

  /// The number of the part under a pixel.
  std::optional<int> part_at(glm::vec2 pixel, ViewInput& view) {
    const auto picked = view.pick(pixel);
    if (!picked || picked->mesh == nullptr) return std::nullopt;
    const std::int64_t triangle = triangle_of_cell(*picked->mesh, picked->cell);
    if (triangle < 0) return std::nullopt;
    const std::vector<std::uint32_t>& groups = groups_of(picked->mesh);
    return std::size_t(triangle) < groups.size() ? std::optional(int(groups[std::size_t(triangle)])) : std::nullopt;
  }

  const std::vector<std::uint32_t>& groups_of(const std::shared_ptr<const Mesh>& mesh) {
    if (grouped_.lock() == mesh && grouped_by_ == *group_by) return groups_;
    const Attribute* attribute = group_by->empty() ? nullptr : mesh->attribute(*group_by);
    groups_.clear();
    // The splitter itself says what is wrong with the array.
    if (group_by->empty()) groups_ = parts_of(*mesh).of_triangle;
    else if (attribute != nullptr) groups_ = lumen::groups_by(*mesh, *attribute).of_triangle;
    grouped_ = mesh;
    grouped_by_ = group_by;
    return groups_;
  }

  void move_on(ViewInput& view) {
    if (!moving_) last_tick_ = view.time();
    moving_ = true;
    view.animate();
  }

  /// A part that has come out from under the pointer does not go back at once, or it would go to and fro; and a press is still its own.
  bool lingers(glm::vec2 position) const { return riffle && hovered_ && glm::distance(position, hovered_at_) < linger_pixels; }

  void hover(glm::vec2 position, ViewInput& view) {
    const auto part = riffle ? part_at(position, view) : std::nullopt;
    if (part && part == hovered_) hovered_at_ = position;
    if (part == hovered_ || lingers(position)) return;
    hovered_ = part;
    hovered_at_ = position;
    move_on(view);
  }

  bool press(const InputEvent& event, ViewInput& view) {
    if (event.button != InputEvent::Button::left || event.shift || event.control || !event.held.empty()) return false;
    const auto part = lingers(event.position) ? hovered_ : part_at(event.position, view);
    if (!part) return false;
    const float out = std::max({degree.get(), at(pulled, *part), at(riffled, *part)});
    held_ = Held{.part = *part, .position = event.position, .way = way_of(*part, event.position, view), .degree = out};
    return true;
  }

  /// The part's way in the view, at the depth of what is under the pixel.
  glm::vec2 way_of(int part, glm::vec2 pixel, ViewInput& view) const {
    const std::vector<float>& all = ways;
    const auto under = view.surface_at(pixel);
    if (!under || all.size() < 3 * std::size_t(part) + 3) return glm::vec2(0);
    const float* way = &all[3 * std::size_t(part)];
    const Camera& camera = view.camera();
    const glm::vec3 eye = glm::mat3(camera.view) * glm::vec3(way[0], way[1], way[2]);
    const float depth = -(camera.view * glm::vec4(*under, 1)).z;
    const float visible = camera.orthographic ? camera.height : 2 * depth * std::tan(glm::radians(camera.field_of_view) / 2);
    return glm::vec2(eye.x, -eye.y) * (float(view.size().y) / std::max(visible, 1e-30f));
  }

  void drag(const InputEvent& event, ViewInput& view) {
    const glm::vec2 pixels = event.position - held_->position;
    if (!held_->dragged && glm::length(pixels) <= click_pixels) return;
    if (!held_->dragged) {
      held_->dragged = true;
      // From here on it is where it was pulled to.
      hovered_.reset();
      riffled.set_default(with(*riffled, held_->part, 0));
      move_on(view);
    }
    // A way that points at the eye has no direction in the view: upward is out.
    const float length = glm::length(held_->way);
    const float by = length > shortest_way ? glm::dot(pixels, held_->way) / (length * length) : -pixels.y / (0.5f * float(view.size().y));
    pulled.set(with(*pulled, held_->part, std::clamp(held_->degree + by, 0.0f, 1.0f)));
  }

  /// A click keeps a part out, or lets go of it.
  bool release() {
    if (!held_) return false;
    if (!held_->dragged) pulled.set(with(*pulled, held_->part, at(pulled, held_->part) > 0 ? 0.0f : 1.0f));
    held_.reset();
    return true;
  }

  bool key(const InputEvent& event, ViewInput& view) {
    if (event.key != "E" || event.control) return false;
    if (event.shift) {
      pulled.set({});
      return true;
    }
    const float now = wanted_degree_.value_or(degree);
    wanted_degree_ = now > 0 ? 0.0f : 1.0f;
    move_on(view);
    return true;
  }

  static float eased(float from, float to, float step) { return from + std::clamp(to - from, -step, step); }

  /// Whether it has further to go.
  bool ease_riffled(float step) {
    std::vector<float> next = riffled;
    if (hovered_ && next.size() <= std::size_t(*hovered_)) next.resize(std::size_t(*hovered_) + 1, 0.0f);
    bool more = false;
    for (std::size_t i = 0; i < next.size(); ++i) {
      const float to = hovered_ && int(i) == *hovered_ ? 1.0f : 0.0f;
      next[i] = eased(next[i], to, step);
      more = more || next[i] != to;
    }
    while (!next.empty() && next.back() == 0) next.pop_back();
    if (next != *riffled) riffled.set_default(std::move(next));
    return more;
  }

  bool ease_degree(float step) {
    if (!wanted_degree_) return false;
    const float next = eased(degree, *wanted_degree_, step);
    if (next != degree) degree.set(next);
    if (next != *wanted_degree_) return true;
    wanted_degree_.reset();
    return false;
  }

  std::optional<int> hovered_;
  glm::vec2 hovered_at_{0};      ///< where the pointer was last on it, pixels
  std::optional<Held> held_;
  std::optional<float> wanted_degree_;
  bool moving_ = false;
  double last_tick_ = 0;
  std::weak_ptr<const Mesh> grouped_;
  std::string grouped_by_;
  std::vector<std::uint32_t> groups_;
};

}  // namespace

LUMEN_PLUGIN(Explode, "interactor.explode", "Parts of a splitter.explode come out under the pointer, and slide when dragged. Li, Agrawala, Curless, Salesin, SIGGRAPH 2008.")
