/// A handle over the picture that moves and turns a cutting plane: its arrow along the normal, its middle across the view, its
/// rings about the plane's own axes (quaternions). Schwankl, Splitting of Meshes in Image-Space, Vienna 2013, has fields for these.

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <lumen/interactor.h>

#include "handle.h"

namespace {

using namespace lumen;
using plane_handle::Part;
using plane_handle::Pose;
using plane_handle::Sight;

constexpr float tolerance = 8;       // pixels beside what is drawn
constexpr float slow = 0.1f;         // Shift
constexpr float turn_step = std::numbers::pi_v<float> / 12;  // Ctrl

struct PlaneHandle : Interactor {
  explicit PlaneHandle(Binding& binding) : Interactor(binding) { follow(); }

  Property<Reference> plane{this, "plane", {}, {.doc = "what it moves: has the properties translation, axis and angle; none: its own, which others may link to", .accepts = "splitter"}};
  Property<glm::vec3> translation{this, "translation", glm::vec3(0), {.unit = "world", .doc = "a point of the plane: the handle's middle; the plane's by a link that the handle makes"}};
  Property<glm::vec3> axis{this, "axis", glm::vec3(0, 1, 0), {.min = -1, .max = 1, .doc = "what the normal, +z, is turned about; the plane's by a link that the handle makes"}};
  Property<float> angle{this, "angle", 0.0f, {.min = -180, .max = 180, .unit = "degrees", .doc = "how far the normal is turned; the plane's by a link that the handle makes"}};
  Property<float> size{this, "size", 0.16f, {.min = 0.02, .max = 1, .unit = "shorter sides", .doc = "length of the arrow, whatever the distance to the eye"}};
  Property<Choice> hovered{this, "hovered", Choice{"none"}, {.doc = "what is under the pointer or held", .choices = {"none", "middle", "arrow", "ring_x", "ring_y"}, .advanced = true}};

  Reads color_in{this, "color"};
  Writes color_out{this, "color", Format::RGBA16F};

  void changed(std::string_view property) override {
    if (property == plane.id()) follow();
  }

  bool input(const InputEvent& event, ViewInput& view) override {
    switch (event.type) {
      case InputEvent::Type::press: return press(event, view);
      case InputEvent::Type::move: return held_ ? drag(event, view) : hover(event, view);
      case InputEvent::Type::release: return std::exchange(held_, std::nullopt).has_value();
      case InputEvent::Type::key: return event.key == "Esc" && std::exchange(held_, std::nullopt).has_value();
      case InputEvent::Type::double_click:
        if (event.button != InputEvent::Button::left || under(event, view) == Part::none) return false;
        take(plane_handle::facing_eye(pose(), sight(view)));
        return true;
      case InputEvent::Type::wheel: case InputEvent::Type::click: return false;
    }
    return false;
  }

  void draw(Frame& frame) override {
    const glm::ivec2 border(frame.border()), whole = frame.size() - 2 * border;
    const Sight seen(frame.camera(), whole, translation);
    const Pose now = pose();
    const glm::mat3 axes = seen.to_eye * glm::mat3_cast(now.turn);
    const glm::vec2 pixel(seen.pixel.x + float(border.x), float(whole.y) - seen.pixel.y + float(border.y));
    const float shown = seen.in_front ? length(whole) : 0;
    const std::array<glm::vec4, 4> texels = {glm::vec4(axes[0], pixel.x), glm::vec4(axes[1], pixel.y), glm::vec4(axes[2], shown), glm::vec4(seen.slant, 0, 0)};
    const gl::Texture& shape = frame.scratch("shape", Format::RGBA32F, {4, 1});
    shape.upload(&texels[0].x);
    frame.fullscreen("interactor/plane_handle.glsl", {.inputs = {{"shape", &shape}}});
  }

 private:
  struct Held {
    Part part;
    Pose start;
    Sight sight;            ///< of the press: the camera may follow the scene
    float length, snap;     ///< pixels; world
    glm::vec2 from, to, pointer;  ///< `to` goes slower than the pointer while Shift is down
  };

  void follow() {
    const auto source = [&](PropertyBase& property) {
      if (plane->empty()) property.unlink();
      else property.link(plane->id + "." + std::string(property.id()));
    };
    source(translation);
    source(axis);
    source(angle);
  }

  float length(glm::ivec2 view) const { return size * float(std::min(view.x, view.y)); }
  Pose pose() const { return {translation, plane_handle::from_axis(axis, angle)}; }
  Sight sight(const ViewInput& view) const { return Sight(view.camera(), view.size(), translation); }
  Part under(const InputEvent& event, const ViewInput& view) const {
    return plane_handle::part_at(pose(), sight(view), length(view.size()), event.position, tolerance);
  }

  /// Sets what differs and nothing else.
  void take(const Pose& next) {
    const Pose now = pose();
    if (next.center != now.center) translation.set(next.center);
    if (next.turn == now.turn) return;
    const auto [about, degrees] = plane_handle::to_axis(next.turn, axis);
    axis.set(about);
    angle.set(degrees);
  }

  void show(Part part, ViewInput& view) {
    hovered.set_default(Choice{std::array{"none", "middle", "arrow", "ring_x", "ring_y"}[std::size_t(part)]});
    if (part != Part::none) view.set_cursor(part == Part::middle ? Cursor::move : Cursor::hand);
  }

  bool hover(const InputEvent& event, ViewInput& view) {
    const Part part = under(event, view);
    show(part, view);
    return part != Part::none;
  }

  bool press(const InputEvent& event, ViewInput& view) {
    held_.reset();
    if (event.button != InputEvent::Button::left || !event.held.empty()) return false;
    const Part part = under(event, view);
    show(part, view);
    if (part == Part::none) return false;
    // A round number, some tens of which go across the scene.
    const float radius = view.scene().radius(), snap = radius > 0 ? std::pow(10.0f, std::floor(std::log10(0.2f * radius))) : 0;
    held_ = Held{part, pose(), sight(view), length(view.size()), snap, event.position, event.position, event.position};
    return true;
  }

  /// Every move starts from the press: going back there undoes it.
  bool drag(const InputEvent& event, ViewInput& view) {
    Held& held = *held_;
    held.to += (event.position - held.pointer) * (event.shift ? slow : 1.0f);
    held.pointer = event.position;
    const float snap = event.control ? held.snap : 0;
    switch (held.part) {
      case Part::none: break;
      case Part::middle: take(plane_handle::moved_across(held.start, held.sight, held.from, held.to, snap)); break;
      case Part::arrow: take(plane_handle::moved_along(held.start, held.sight, held.from, held.to, snap)); break;
      case Part::ring_x: case Part::ring_y:
        take(plane_handle::turned(held.start, held.part, held.sight, held.length, held.from, held.to, event.control ? turn_step : 0));
        break;
    }
    show(held.part, view);
    return true;
  }

  std::optional<Held> held_;
};

}  // namespace

LUMEN_PLUGIN(PlaneHandle, "interactor.plane_handle", "A handle that moves and turns a cutting plane in the view. Schwankl, Splitting of Meshes in Image-Space, Vienna 2013.")
