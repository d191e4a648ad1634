#include "navigation.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace orbit {
namespace {

constexpr float margin = 1.05f;
constexpr float smallest = 1e-6f, largest = 1e12f;

/// From the view's center, in world units, x right and y up, at the pivot's depth.
glm::vec2 from_center(const Pose& pose, const Lens& lens, glm::vec2 pixel, glm::ivec2 size) {
  const glm::vec2 centered(pixel.x - 0.5f * static_cast<float>(size.x), 0.5f * static_cast<float>(size.y) - pixel.y);
  return centered * world_per_pixel(pose, lens, size);
}

/// An eye-space offset in world space.
glm::vec3 in_world(const Pose& pose, glm::vec3 eye) { return glm::conjugate(pose.rotation) * eye; }

}  // namespace

glm::mat4 view_matrix(const Pose& pose) {
  return glm::translate(glm::mat4(1), {0, 0, -pose.distance}) * glm::mat4_cast(pose.rotation) * glm::translate(glm::mat4(1), -pose.pivot);
}

float world_per_pixel(const Pose& pose, const Lens& lens, glm::ivec2 size) {
  const float visible = lens.orthographic ? pose.height : 2 * pose.distance * std::tan(glm::radians(lens.field_of_view) / 2);
  return visible / static_cast<float>(std::max(1, size.y));
}

Pose panned(const Pose& pose, const Lens& lens, glm::vec2 pixels, glm::ivec2 size) {
  Pose moved = pose;
  moved.pivot += in_world(pose, glm::vec3(-pixels.x, pixels.y, 0) * world_per_pixel(pose, lens, size));
  return moved;
}

Pose zoomed(const Pose& pose, const Lens& lens, float factor, glm::vec2 pointer, glm::ivec2 size) {
  Pose moved = pose;
  const glm::vec3 anchor = pose.pivot + in_world(pose, glm::vec3(from_center(pose, lens, pointer, size), 0));
  moved.pivot = anchor + (pose.pivot - anchor) * factor;
  // Both, so that switching the projection keeps the size of what is seen.
  moved.distance = std::clamp(pose.distance * factor, smallest, largest);
  moved.height = std::clamp(pose.height * factor, smallest, largest);
  return moved;
}

Pose turned(const Pose& pose, glm::vec2 pixels, glm::ivec2 size) {
  const float radians = 3.14159265f / static_cast<float>(std::max(1, std::min(size.x, size.y)));
  Pose moved = pose;
  moved.rotation = glm::normalize(glm::angleAxis(pixels.y * radians, glm::vec3(1, 0, 0)) * pose.rotation * glm::angleAxis(pixels.x * radians, glm::vec3(0, 0, 1)));
  return moved;
}

Pose rolled(const Pose& pose, float degrees) {
  Pose moved = pose;
  moved.rotation = glm::normalize(glm::angleAxis(glm::radians(degrees), glm::vec3(0, 0, 1)) * pose.rotation);
  return moved;
}

Pose fitted(const Pose& pose, const Lens& lens, const lumen::Bounds& bounds, float aspect) {
  if (bounds.empty()) return pose;
  Pose moved = pose;
  moved.pivot = bounds.center();
  const glm::vec3 half = 0.5f * (bounds.max - bounds.min);
  const float slope = std::tan(glm::radians(lens.field_of_view) / 2);
  const float width = std::max(aspect, 1e-3f);
  float distance = 0, height = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    const glm::vec3 eye = pose.rotation * (sign * half);
    const float extent = margin * std::max(std::abs(eye.y), std::abs(eye.x) / width);
    distance = std::max(distance, eye.z + extent / slope);
    height = std::max(height, 2 * extent);
  }
  const float least = bounds.radius() > 0 ? 1e-3f * bounds.radius() : 1;
  moved.distance = std::max(distance, least);
  moved.height = std::max(height, least);
  return moved;
}

Pose between(const Pose& from, const Pose& to, float along) {
  const float t = along * along * (3 - 2 * along);
  const auto geometric = [&](float a, float b) { return a * std::pow(b / a, t); };
  Pose pose;
  pose.rotation = glm::slerp(from.rotation, to.rotation, t);
  pose.pivot = glm::mix(from.pivot, to.pivot, t);
  pose.distance = geometric(from.distance, to.distance);
  pose.height = geometric(from.height, to.height);
  return pose;
}

std::optional<glm::quat> standard_view(const std::string& key, bool opposite) {
  const float half = 3.14159265f / 2;
  const auto about = [](float angle, glm::vec3 axis) { return glm::angleAxis(angle, axis); };
  const glm::vec3 x(1, 0, 0), z(0, 0, 1);
  const glm::quat front = about(-half, x);
  if (key == "1") return opposite ? front * about(2 * half, z) : front;
  if (key == "3") return front * about(opposite ? half : -half, z);
  if (key == "7") return opposite ? about(2 * half, x) : glm::quat(1, 0, 0, 0);
  return std::nullopt;
}

}  // namespace orbit
