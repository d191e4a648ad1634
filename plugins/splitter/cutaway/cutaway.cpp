/// Holes in what hides objects of interest, as seen by the view's camera: their walls slope away from the objects' silhouettes. Burns,
/// Finkelstein, Adaptive Cutaways for Comprehensible Rendering of Polygonal Scenes, SIGGRAPH Asia 2008; the distance transform by
/// jump flooding, Rong, Tan, Jump Flooding in GPU with Applications to Voronoi Diagram and Distance Transform, I3D 2006.

#include <algorithm>
#include <bit>

#include <lumen/splitter.h>

#include "../kept_parts.h"

namespace {

constexpr const char* shader = "splitter/cutaway.glsl";

struct Cutaway : lumen::Splitter {
  explicit Cutaway(lumen::Binding& binding) : Splitter(binding) { changed(keep.id()); }

  lumen::Property<lumen::References> interest{this, "interest", {}, {.doc = "opaque surfaces that nothing cut by this may hide; not themselves cut by it", .accepts = "renderer"}};
  lumen::Property<std::vector<int>> parts{this, "parts", {}, {.min = 0, .doc = "numbers of parts of the cut surfaces that are of interest, too, and stay whole"}};
  lumen::Property<float> slope{this, "slope", 40.0f, {.min = 0, .max = 85, .unit = "degrees", .doc = "between the line of sight and the hole's wall; 0 drills straight"}};
  lumen::Property<float> margin{this, "margin", 0.0f, {.min = 0, .max = 1, .unit = "scene radii", .doc = "room between the silhouettes of interest and the hole"}};
  lumen::Property<lumen::Choice> keep{this, "keep", {"rest"}, {.doc = "what stays of the surface: the rest, or what is cut out of it, to be drawn as a ghost", .choices = {"rest", "removed"}}};
  lumen::Property<int> reduction{this, "reduction", 4, {.min = 1, .max = 16, .unit = "pixels", .doc = "width of the squares that share their search for the wall", .advanced = true}};
  lumen::Interior interior{this, "cut_surface"};

  bool removes() const override { return true; }
  lumen::TextureInputs inputs() const override { return {{"cutaway_hull", hull_}, {"cutaway_seeds", seeds_}}; }

  void changed(std::string_view property) override {
    if (property == keep.id()) interior.look.set_default(lumen::Choice{ghost() ? "none" : "cut_surface"});
  }

  lumen::Split split(const lumen::SplitSurface& surface) override {
    if (nothing_of_interest_) report_nothing();
    return kept_.split(surface, parts, !ghost());
  }

  void prepare(lumen::Frame& frame) override {
    const lumen::gl::Texture& hull = frame.scratch("hull", lumen::Format::R32F, frame.size());
    bool any = false;
    const auto wanted = [&](const std::string& renderer, const lumen::Part& part) {
      const auto& ids = interest->ids;
      const bool is = std::find(ids.begin(), ids.end(), renderer) != ids.end() || (!parts->empty() && !part.removable);
      any = any || is;
      return is;
    };
    frame.draw_depth(frame.camera(), hull, {.farthest = true, .wanted = wanted});
    hull_ = &hull;
    seeds_ = &spread(frame, hull, any);
    nothing_of_interest_ = !any && (!interest->ids.empty() || !parts->empty());
    if (nothing_of_interest_) report_nothing();
  }

 private:
  bool ghost() const { return keep.get() == "removed"; }

  void report_nothing() const { report(lumen::Severity::note, "nothing of interest is drawn opaque in this view: nothing is cut"); }

  /// For each square of the picture, the pixel of interest whose cone reaches farthest there: its place and depth.
  const lumen::gl::Texture& spread(lumen::Frame& frame, const lumen::gl::Texture& hull, bool any) const {
    const glm::ivec2 size = (frame.size() + reduction.get() - 1) / reduction.get();
    const lumen::gl::Texture *from = &frame.scratch("seeds", lumen::Format::RGBA32F, size), *to = &frame.scratch("other_seeds", lumen::Format::RGBA32F, size);
    const lumen::gl::Texture& stride = frame.scratch("stride", lumen::Format::R32F, {1, 1});
    frame.fullscreen(shader, {.function = "seed", .target = from, .inputs = {{"cutaway_hull", &hull}}});
    if (!any) return *from;
    const auto step = [&](int width) {
      const float value = float(width);
      stride.upload(&value);
      frame.fullscreen(shader, {.function = "spread", .target = to, .inputs = {{"cutaway_hull", &hull}, {"cutaway_seeds", from}, {"stride", &stride}}});
      std::swap(from, to);
    };
    step(1);  // before the flood, it makes hardly any of its errors remain
    for (int width = int(std::bit_ceil(unsigned(std::max(size.x, size.y)))) / 2; width >= 1; width /= 2) step(width);
    return *from;
  }

  KeptParts kept_;
  const lumen::gl::Texture *hull_ = nullptr, *seeds_ = nullptr;  ///< of the frame prepared last
  bool nothing_of_interest_ = false;
};

}  // namespace

LUMEN_PLUGIN(Cutaway, "splitter.cutaway", "Holes in what hides objects of interest, as the camera sees them, with sloping walls. Burns, Finkelstein, Adaptive Cutaways for Comprehensible Rendering of Polygonal Scenes, SIGGRAPH Asia 2008.")
