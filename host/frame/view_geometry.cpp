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

ViewGeometry make_geometry(const lumen::Camera& camera, const PictureWindow& window, const lumen::Bounds& scene, const lumen::Bounds& drawn,
                           const lumen::Bounds& transparent, double time) {
  ViewGeometry geometry{.camera = camera, .viewport = window.size * window.scale, .border = window.border * window.scale};
  geometry.extent = along_axis(camera.view, scene);
  geometry.scene_radius = scene.empty() ? 1.0f : std::max(scene.radius(), 1e-12f);

  // The plane at depth 1 (orthographic: anywhere); offsets move it under the pixel grid.
  const glm::vec2 size(geometry.size()), picture(window.picture);
  const float half_height = camera.orthographic ? 0.5f * camera.height : std::tan(glm::radians(0.5f * camera.field_of_view));
  const float pixel = 2 * half_height / picture.y;
  const glm::vec2 low = pixel * (glm::vec2(window.origin - window.border) - 0.5f * picture + window.offset);
  const glm::vec2 high = pixel * (glm::vec2(window.origin + window.size + window.border) - 0.5f * picture + window.offset);

  const glm::vec2 clip = along_axis(camera.view, drawn);
  const float span = std::max(clip.y - clip.x, 1e-6f * std::max(std::abs(clip.y), 1e-12f));
  const float far = clip.y + 0.01f * span;
  const float near = camera.orthographic ? clip.x - 0.01f * span : std::max(clip.x - 0.01f * span, std::max(far, 1e-12f) * 1e-4f);
  FrameBlock& block = geometry.block;
  block.view = camera.view;
  block.projection = camera.orthographic ? glm::ortho(low.x, high.x, low.y, high.y, near, far)
                                         : glm::frustum(low.x * near, high.x * near, low.y * near, high.y * near, near, std::max(far, near * 1.001f));
  block.unproject = glm::vec4(high - low, low);
  block.size = glm::vec4(size, float(geometry.border), float(window.scale));
  block.extent = glm::vec4(geometry.extent, geometry.scene_radius, camera.orthographic ? 1 : 0);
  block.transparent_extent = glm::vec4(along_axis(camera.view, transparent), float(window.scale) / pixel, float(time));
  geometry.transparent = pixels_of(geometry, transparent);
  return geometry;
}

PixelBox pixels_of(const ViewGeometry& geometry, const lumen::Bounds& box) {
  constexpr float margin = 32;
  const glm::vec2 size(geometry.size());
  if (box.empty()) return {};
  const glm::mat4 to_clip = geometry.world_to_clip();
  glm::vec2 low(1), high(-1);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec4 clip = to_clip * glm::vec4(corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y, corner & 4 ? box.max.z : box.min.z, 1);
    if (clip.w <= 1e-6f * std::abs(clip.z)) return {glm::ivec2(0), geometry.size()};  // beside or behind the eye: anywhere
    low = corner == 0 ? glm::vec2(clip) / clip.w : glm::min(low, glm::vec2(clip) / clip.w);
    high = corner == 0 ? glm::vec2(clip) / clip.w : glm::max(high, glm::vec2(clip) / clip.w);
  }
  const auto inside = [&](glm::vec2 pixel) { return glm::ivec2(glm::clamp(pixel, glm::vec2(0), size)); };
  return {inside(glm::floor((0.5f * low + 0.5f) * size - margin)), inside(glm::ceil((0.5f * high + 0.5f) * size + margin))};
}

PixelBox united(const PixelBox& a, const PixelBox& b) {
  if (a.empty()) return b;
  return b.empty() ? a : PixelBox{glm::min(a.begin, b.begin), glm::max(a.end, b.end)};
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

glm::vec2 sample_offset(int index, int rounds) {
  static constexpr glm::vec2 rotated[] = {{-1, -3}, {1, 3}, {3, -1}, {-3, 1}};
  return rounds == 1 ? glm::vec2(0) : rotated[index % 4] / 16.0f;
}

}  // namespace lumenshop
