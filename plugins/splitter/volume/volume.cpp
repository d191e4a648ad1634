/// A simple volume cut out of surfaces: a sphere, box, wedge or tube. Knoedel, Hachet, Guitton, Interactive Generation and
/// Modification of Cutaway Illustrations for Polygonal Models, Smart Graphics 2009. Placed by hand, or where it shows what is of
/// interest and cuts little: Sigg, Fuchs, Carnecky, Peikert, Intelligent Cutaway Illustrations, PacificVis 2012.

#include <algorithm>
#include <array>

#include <lumen/mesh.h>
#include <lumen/splitter.h>

#include "../kept_parts.h"
#include "cut.h"
#include "sight.h"

namespace {

constexpr int sight_pixels = 96;  // on the longer side of the picture that a placement is found in

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
  lumen::Property<std::vector<int>> whole{this, "whole", {}, {.min = 0, .doc = "numbers of parts that stay whole"}};
  lumen::Property<lumen::Choice> keep{this, "keep", {"rest"}, {.doc = "what stays of the surface: the rest, or what is cut out of it", .choices = {"rest", "removed"}}};
  lumen::Property<lumen::Choice> place{this, "place", {"by_hand"}, {.doc = "where the volume is: as set, or what of its center and lengths is not set follows the camera of the view that leads so that it shows what is of interest and cuts little", .group = "Placement", .choices = {"by_hand", "by_interest"}}};
  lumen::Property<lumen::References> interest{this, "interest", {}, {.doc = "opaque surfaces to be seen, beside the parts that stay whole", .group = "Placement", .when = "place = by_interest", .accepts = "renderer"}};
  lumen::Property<float> alpha{this, "alpha", 1.0f, {.min = 0, .max = 100, .doc = "worth of what is of interest and in sight", .group = "Placement", .when = "place = by_interest"}};
  lumen::Property<float> beta{this, "beta", 0.25f, {.min = 0, .max = 100, .doc = "price of a volume as large as the scene's sphere", .group = "Placement", .when = "place = by_interest"}};
  lumen::Interior interior{this, "cut_surface"};

  bool removes() const override { return true; }

  void changed(std::string_view property) override {
    if (property == keep.id()) interior.look.set_default(lumen::Choice{ghost() ? "none" : "cut_surface"});
  }

  lumen::Split split(const lumen::SplitSurface& surface) override {
    std::erase_if(cut_, [&](const std::weak_ptr<const lumen::Mesh>& mesh) { return mesh.expired() || mesh.lock() == surface.mesh; });
    if (surface.mesh != nullptr) cut_.push_back(surface.mesh);
    return kept_.split(surface, whole, !ghost());
  }

  void prepare(lumen::Frame& frame) override {
    fit(shown(frame));
    if (place.get() == "by_interest" && frame.leads()) place_in(frame);
  }

 private:
  bool ghost() const { return keep.get() == "removed"; }

  void fit(const lumen::Bounds& scene) {
    // Views may show different things: what still fits one stays as it is.
    if (scene.empty() || (fitted_.radius() > 0 && fits(scene))) return;
    fitted_ = scene;
    center.set_default(fitted_center());
    radius.set_default(fitted_unit());
    size.set_default(glm::vec3(2 * fitted_unit()));
    length.set_default(2 * fitted_unit());
  }

  void place_in(lumen::Frame& frame) {
    const glm::ivec2 pixels = glm::max(frame.size() * sight_pixels / std::max(frame.size().x, frame.size().y), 1);
    const lumen::gl::Texture& depth = frame.scratch("interest", lumen::Format::R32F, pixels);
    frame.draw_depth(frame.camera(), depth, {.wanted = [&](const std::string& renderer, const lumen::Part& part) {
      return std::find(interest->ids.begin(), interest->ids.end(), renderer) != interest->ids.end() || (!whole->empty() && !part.removable);
    }});
    const float radius_of_scene = frame.scene_radius();
    Sight sight(frame.camera(), pixels, depth.download());
    for (const lumen::TracedSurface& surface : frame.traced_surfaces()) {
      if (std::none_of(cut_.begin(), cut_.end(), [&](const std::weak_ptr<const lumen::Mesh>& mesh) { return mesh.lock() == surface.mesh; })) continue;
      const auto groups = kept_.groups(surface.mesh, whole);
      sight.add(*surface.mesh, surface.object_to_world, groups == nullptr ? std::span<const std::uint32_t>() : std::span<const std::uint32_t>(*groups), 1e-4f * radius_of_scene);
    }
    const bool sized = shape.get() == "box" ? !size.is_set() : !radius.is_set() && (shape.get() == "sphere" || !length.is_set());
    // From what is set and the scene alone, so that a view is the same whatever was shown before.
    const Cut begin = unplaced();
    const Cut found = sight.hidden() ? placed(sight, begin, !center.is_set(), sized, alpha, beta, Cut{.radius = radius_of_scene}.volume())
                      : sized        ? begin.scaled(0) : begin;
    // What is set keeps its default: were that the same, nothing would change, and be found anew, once it is set no more.
    if (!center.is_set()) center.set_default(found.center);
    if (!radius.is_set()) radius.set_default(found.radius);
    if (!size.is_set()) size.set_default(found.size);
    if (!length.is_set()) length.set_default(found.length);
  }

  /// With the lengths that fit the scene where none are set.
  Cut unplaced() const {
    constexpr std::array<const char*, 4> names = {"sphere", "box", "wedge", "tube"};
    const auto index = std::find(names.begin(), names.end(), shape->name) - names.begin();
    const float unit = fitted_unit();
    return {.shape = Cut::Shape(index), .center = center.is_set() ? *center : fitted_center(), .rotation = rotation,
            .radius = radius.is_set() ? *radius : unit, .size = size.is_set() ? *size : glm::vec3(2 * unit), .length = length.is_set() ? *length : 2 * unit, .angle = angle};
  }

  float fitted_unit() const { return 0.5f * std::max(fitted_.radius(), 1e-20f); }
  glm::vec3 fitted_center() const { return {fitted_.center().x, fitted_.min.y, fitted_.center().z}; }

  /// Whether a volume that was fitted to another scene is of use in this one.
  bool fits(const lumen::Bounds& scene) const {
    const float ratio = fitted_.radius() / std::max(scene.radius(), 1e-20f);
    return ratio > 0.25f && ratio < 4 && glm::distance(fitted_.center(), scene.center()) < scene.radius();
  }

  KeptParts kept_;
  std::vector<std::weak_ptr<const lumen::Mesh>> cut_;  ///< of the surfaces that it serves
  lumen::Bounds fitted_;  ///< the scene that the defaults are made for
};

}  // namespace

LUMEN_PLUGIN(Volume, "splitter.volume", "A sphere, box, wedge or tube cut out of surfaces. Knoedel, Hachet, Guitton, Interactive Generation and Modification of Cutaway Illustrations for Polygonal Models, Smart Graphics 2009; placed by interest: Sigg, Fuchs, Carnecky, Peikert, PacificVis 2012.")
