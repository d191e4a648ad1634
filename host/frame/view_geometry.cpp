#include "frame/view_geometry.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace lumenshop {
namespace {

/// Distances of the bounds' sphere along the view axis.
glm::vec2 along_axis(const glm::mat4& view, const lumen::Bounds& bounds) {
  if (bounds.empty()) return {0, 1};
  const float center = -(view * glm::vec4(bounds.center(), 1)).z;
  const float radius = std::max(bounds.radius(), 1e-12f);
  return {center - radius, center + radius};
}

}  // namespace

ViewGeometry make_geometry(const lumen::Camera& camera, glm::ivec2 viewport, int border, glm::vec2 jitter, const lumen::Bounds& scene,
                           const lumen::Bounds& drawn, const lumen::Bounds& transparent, double time) {
  ViewGeometry geometry{.camera = camera, .viewport = viewport, .border = border};
  geometry.extent = along_axis(camera.view, scene);
  geometry.scene_radius = scene.empty() ? 1.0f : std::max(scene.radius(), 1e-12f);

  const glm::vec2 size(geometry.size());
  const float half_height = camera.orthographic ? 0.5f * camera.height : std::tan(glm::radians(0.5f * camera.field_of_view));
  const glm::vec2 half = glm::vec2(half_height * float(viewport.x) / float(viewport.y), half_height) * (size / glm::vec2(viewport));
  const glm::vec2 offset = jitter * 2.0f * half / size;  // the plane moves under the pixel grid

  const glm::vec2 clip = along_axis(camera.view, drawn);
  const float span = std::max(clip.y - clip.x, 1e-6f * std::max(std::abs(clip.y), 1e-12f));
  const float far = clip.y + 0.01f * span;
  const float near = camera.orthographic ? clip.x - 0.01f * span : std::max(clip.x - 0.01f * span, std::max(far, 1e-12f) * 1e-4f);
  const glm::vec2 low = -half + offset, high = half + offset;
  FrameBlock& block = geometry.block;
  block.view = camera.view;
  block.projection = camera.orthographic ? glm::ortho(low.x, high.x, low.y, high.y, near, far)
                                         : glm::frustum(low.x * near, high.x * near, low.y * near, high.y * near, near, std::max(far, near * 1.001f));
  block.unproject = glm::vec4(2.0f * half, low);
  block.size = glm::vec4(size, float(border), 0);
  block.extent = glm::vec4(geometry.extent, geometry.scene_radius, camera.orthographic ? 1 : 0);
  block.transparent_extent = glm::vec4(along_axis(camera.view, transparent), size.y / (2.0f * half.y), float(time));
  return geometry;
}

lumen::Camera fitting_camera(const lumen::Bounds& scene, float aspect) {
  lumen::Camera camera;
  const float radius = scene.empty() ? 1.0f : std::max(scene.radius(), 1e-12f);
  camera.pivot = scene.empty() ? glm::vec3(0) : scene.center();
  const float half = glm::radians(0.5f * camera.field_of_view);
  camera.distance = 1.05f * radius / std::sin(std::min(half, std::atan(std::tan(half) * aspect)));
  camera.view = glm::translate(glm::mat4(1), glm::vec3(0, 0, -camera.distance)) * glm::translate(glm::mat4(1), -camera.pivot);
  return camera;
}

glm::vec2 sample_offset(int index) {
  const auto wrapped = [&](double step) {
    const double x = index * step;
    const double fraction = x - std::floor(x);
    return float(fraction < 0.5 ? fraction : fraction - 1.0);
  };
  return {wrapped(0.7548776662466927), wrapped(0.5698402909980532)};
}

}  // namespace lumenshop
