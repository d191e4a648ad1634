/// A simple volume cut out of surfaces: a sphere, box, wedge or tube. Knoedel, Hachet, Guitton, Interactive Generation and
/// Modification of Cutaway Illustrations for Polygonal Models, Smart Graphics 2009.

#include <algorithm>

#include <lumen/mesh.h>
#include <lumen/splitter.h>

#include "../kept_parts.h"

namespace {

/// Of all that the view shows.
lumen::Bounds shown(const lumen::Frame& frame) {
  lumen::Bounds bounds;
  for (const lumen::TracedSurface& surface : frame.traced_surfaces()) bounds.include(surface.mesh->bounds().transformed(surface.object_to_world));
  return bounds;
}

struct Volume : lumen::Splitter {
  explicit Volume(lumen::Binding& binding) : Splitter(binding) { changed(keep.id()); }

  lumen::Property<lumen::Choice> shape{this, "shape", {"sphere"}, {.doc = "of the volume; wedge and tube lie along its own z axis, the wedge opens about its own x axis", .choices = {"sphere", "box", "wedge", "tube"}}};
  lumen::Property<glm::vec3> center{this, "center", glm::vec3(0), {.unit = "world", .doc = "of the volume, of the wedge a point of its edge; unless set, before the scene's middle"}};
  lumen::Property<glm::quat> rotation{this, "rotation", glm::quat(1, 0, 0, 0), {.doc = "the volume's own axes to the world's", .when = "shape != sphere"}};
  lumen::Property<float> radius{this, "radius", 0.0f, {.min = 0, .max = 1e12, .unit = "world", .doc = "of sphere, wedge and tube; unless set, from the scene's size", .when = "shape != box"}};
  lumen::Property<glm::vec3> size{this, "size", glm::vec3(0), {.min = 0, .max = 1e12, .unit = "world", .doc = "edges of the box along its own axes; unless set, from the scene's size", .when = "shape = box"}};
  lumen::Property<float> length{this, "length", 0.0f, {.min = 0, .max = 1e12, .unit = "world", .doc = "of wedge and tube, centered; unless set, from the scene's size"}};
  lumen::Property<float> angle{this, "angle", 90.0f, {.min = 0, .max = 180, .unit = "degrees", .doc = "of the wedge's edge", .when = "shape = wedge"}};
  lumen::Property<std::vector<int>> whole{this, "whole", {}, {.min = 0, .doc = "numbers of connected parts that stay whole"}};
  lumen::Property<lumen::Choice> keep{this, "keep", {"rest"}, {.doc = "what stays of the surface: the rest, or what is cut out of it", .choices = {"rest", "removed"}}};
  lumen::Interior interior{this, "cut_surface"};

  bool removes() const override { return true; }

  void changed(std::string_view property) override {
    if (property == keep.id()) interior.look.set_default(lumen::Choice{ghost() ? "none" : "cut_surface"});
  }

  lumen::Split split(const lumen::SplitSurface& surface) override { return kept_.split(surface, whole, !ghost()); }

  void prepare(lumen::Frame& frame) override {
    const lumen::Bounds scene = shown(frame);
    // Views may show different things: what still fits one stays as it is.
    if (scene.empty() || (fitted_.radius() > 0 && fits(scene))) return;
    fitted_ = scene;
    const float unit = 0.5f * std::max(scene.radius(), 1e-20f);
    center.set_default(glm::vec3(scene.center().x, scene.min.y, scene.center().z));
    radius.set_default(unit);
    size.set_default(glm::vec3(2 * unit));
    length.set_default(2 * unit);
  }

 private:
  bool ghost() const { return keep.get() == "removed"; }
  /// Whether a volume that was fitted to another scene is of use in this one.
  bool fits(const lumen::Bounds& scene) const {
    const float ratio = fitted_.radius() / std::max(scene.radius(), 1e-20f);
    return ratio > 0.25f && ratio < 4 && glm::distance(fitted_.center(), scene.center()) < scene.radius();
  }

  KeptParts kept_;
  lumen::Bounds fitted_;  ///< the scene that the defaults are made for
};

}  // namespace

LUMEN_PLUGIN(Volume, "splitter.volume", "A sphere, box, wedge or tube cut out of surfaces. Knoedel, Hachet, Guitton, Interactive Generation and Modification of Cutaway Illustrations for Polygonal Models, Smart Graphics 2009.")
