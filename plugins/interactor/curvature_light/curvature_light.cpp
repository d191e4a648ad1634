/// A light that places itself: where its highlight shows best how a surface bends, as the camera sees it. Several share the surface, each
/// a patch. After Lee, Hao, Varshney, Geometry-Dependent Lighting, IEEE TVCG 12(2), 2006, whose lights shine on their own patches alone;
/// here, they shine on all.

#include <glm/trigonometric.hpp>
#include <lumen/interactor.h>
#include <lumen/mesh.h>

#include "highlights.h"

namespace {

using namespace lumen;

constexpr std::size_t most_points = 20000;  // the directions are means of many

struct CurvatureLight : Interactor {
  using Interactor::Interactor;

  Input<Mesh> mesh{this, "mesh", {.doc = "the surface, with its curvature (of filter.curvature); without, all places count the same"}};
  Property<glm::mat4> transform{this, "transform", glm::mat4(1), {.doc = "object to world: link it to the surface's"}};
  Property<int> lights{this, "lights", 2, {.min = 1, .max = 8, .doc = "how many share the surface: one of these instances for each, with the same number"}};
  Property<int> number{this, "number", 0, {.min = 0, .max = 7, .doc = "which of them this is; 0 shines on the patch that bends most"}};
  Property<float> widest{this, "widest", 60.0f, {.min = 0, .max = 180, .unit = "degrees", .doc = "the light leaves the direction to the eye by no more: lights from behind would leave the middle dark"}};
  Property<Color> color{this, "color", Color(1, 1, 1), {.min = 0, .max = 1, .doc = "linear color"}};
  Property<float> intensity{this, "intensity", 0.6f, {.min = 0, .max = 100, .doc = "times the color"}};

  bool is_light() const override { return true; }

  void changed(std::string_view property) override {
    if (property == mesh.id() || property == transform.id()) known_ = false;
    if (property == lights.id() || property == widest.id()) found_ = false;
  }

  /// From the eye, dark, while there is no patch for it.
  Light light(const Camera& camera) const override {
    const std::vector<glm::vec3>& directions = directions_for(camera);
    const auto own = std::size_t(number.get());
    if (own >= directions.size()) return {.direction = glm::vec3(glm::inverse(camera.view)[2]), .color = glm::vec3(0)};
    return {.direction = directions[own], .color = color->rgb * intensity.get()};
  }

 private:
  /// Asked for in every pass of a frame: found once for a camera.
  const std::vector<glm::vec3>& directions_for(const Camera& camera) const {
    if (!known_) {
      const auto surface = mesh.get();
      points_ = surface == nullptr ? CurvedPoints{} : curved_points(*surface, transform, most_points);
      known_ = true;
      found_ = false;
    }
    if (!found_ || camera.view != view_ || camera.orthographic != orthographic_) {
      directions_ = highlight_directions(points_, camera, lights, glm::radians(widest.get()));
      view_ = camera.view;
      orthographic_ = camera.orthographic;
      found_ = true;
    }
    return directions_;
  }

  mutable CurvedPoints points_;
  mutable std::vector<glm::vec3> directions_;
  mutable glm::mat4 view_{0};
  mutable bool orthographic_ = false, known_ = false, found_ = false;
};

}  // namespace

LUMEN_PLUGIN(CurvatureLight, "interactor.curvature_light", "a light that places itself where its highlight shows best how a surface bends. After Lee, Hao, Varshney, Geometry-Dependent Lighting, TVCG 2006")
