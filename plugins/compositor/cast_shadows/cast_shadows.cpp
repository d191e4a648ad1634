/// Shadows that opaque surfaces cast in one light: a shadow map with percentage-closer filtering. Williams, Casting Curved Shadows
/// on Curved Surfaces, SIGGRAPH 1978; Reeves, Salesin, Cook, Rendering Antialiased Shadows with Depth Maps, SIGGRAPH 1987.

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>
#include <lumen/compositor.h>
#include <lumen/mesh.h>

namespace {

constexpr float margin = 1.02f, widest = 150;  // degrees

lumen::Bounds casters(const lumen::Frame& frame) {
  lumen::Bounds bounds;
  for (const lumen::TracedSurface& surface : frame.traced_surfaces())
    if (!surface.transparent)
      for (const lumen::Part& part : surface.split.parts) bounds.include(surface.mesh->bounds().transformed(part.transform * surface.object_to_world));
  return bounds;
}

struct CastShadows : lumen::Compositor {
  using Compositor::Compositor;

  lumen::Property<int> light{this, "light", 0, {.min = 0, .max = 15, .doc = "which of the view's lights casts them, from 0"}};
  lumen::Property<float> strength{this, "strength", 0.6f, {.min = 0, .max = 1, .doc = "how much of the picture's color the shadow takes; 0 leaves the picture as it is"}};
  lumen::Property<lumen::Color> color{this, "color", {0, 0, 0}, {.min = 0, .max = 1, .doc = "what the picture is multiplied by in full shadow"}};
  lumen::Property<float> softness{this, "softness", 0.01f, {.min = 0, .max = 0.2, .unit = "scene radii", .doc = "radius of the penumbra; 0 is a hard shadow"}};
  lumen::Property<int> resolution{this, "resolution", 1024, {.min = 64, .max = 4096, .unit = "texels", .doc = "width and height of the shadow map", .advanced = true}};
  lumen::Property<float> bias{this, "bias", 1.5f, {.min = 0, .max = 20, .unit = "texels", .doc = "how far surfaces are lifted along their normals, so that they do not shade themselves", .advanced = true}};
  lumen::Property<int> samples{this, "samples", 16, {.min = 1, .max = 128, .doc = "taps of a soft shadow, each of four texels", .constant = true}};

  lumen::Reads depth{this, "depth"}, normal{this, "normal"}, transparent{this, "transparent"};

  void render(lumen::Frame& frame) override {
    constexpr const char* shader = "compositor/cast_shadows.glsl";
    const auto lights = frame.lights();
    const lumen::Bounds bounds = casters(frame);
    if (int(lights.size()) <= light) report(lumen::Severity::warning, "the view has no light " + std::to_string(light.get()) + ": no shadows");
    if (int(lights.size()) <= light || bounds.empty()) return frame.fullscreen(shader, {.function = "unshadowed"});

    const lumen::Camera from = camera_of(lights[std::size_t(light.get())], bounds);
    const auto& map = frame.scratch("shadow_map", lumen::Format::R32F, glm::ivec2(resolution.get()));
    frame.draw_depth(from, map);
    // Eye space to the light's, and how wide its picture is (at distance 1 if it is a point's).
    const glm::mat4 to_light = from.view * glm::inverse(frame.camera().view);
    const float width = from.orthographic ? from.height : 2 * std::tan(glm::radians(from.field_of_view) / 2);
    const std::array<glm::vec4, 5> place{to_light[0], to_light[1], to_light[2], to_light[3], glm::vec4(width, from.orthographic ? 1 : 0, 0, 0)};
    const auto& seen_from = frame.scratch("seen_from", lumen::Format::RGBA32F, {5, 1});
    seen_from.upload(&place[0].x);
    frame.fullscreen(shader, {.inputs = {{"shadow_map", &map}, {"seen_from", &seen_from}}});
  }

  /// From where the light is, or from outside the scene, all that casts shadows in sight.
  lumen::Camera camera_of(const lumen::Light& source, const lumen::Bounds& bounds) const {
    const glm::vec3 center = bounds.center();
    const float radius = std::max(bounds.radius(), 1e-12f);
    glm::vec3 eye = center + 2 * radius * source.direction;
    lumen::Camera camera{.orthographic = true, .height = 2 * margin * radius};
    if (source.point) {
      eye = source.position;
      const float distance = glm::distance(eye, center);
      const float wanted = distance > radius ? 2 * margin * glm::degrees(std::asin(radius / distance)) : 180;
      if (wanted > widest) report(lumen::Severity::note, "the light is in the scene or close to it: shadows only within 75 degrees of the scene's center");
      camera.orthographic = false;
      camera.field_of_view = std::min(wanted, widest);
      if (distance < 1e-6f * radius) eye += glm::vec3(0, 0, 1e-3f * radius);
    }
    const glm::vec3 axis = glm::normalize(center - eye);
    const glm::vec3 up = std::abs(axis.z) < 0.9f ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0);
    camera.view = glm::lookAt(eye, eye + axis, up);
    camera.pivot = center;
    camera.distance = glm::distance(eye, center);
    return camera;
  }
};

}  // namespace

LUMEN_PLUGIN(CastShadows, "compositor.cast_shadows", "Shadows cast in one light. Williams, SIGGRAPH 1978; Reeves, Salesin, Cook, Rendering Antialiased Shadows with Depth Maps, SIGGRAPH 1987.")
