#include "cut_volume.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace cut_volume {
namespace {

using Polyline = std::vector<glm::vec3>;

constexpr int arc_steps = 64;
constexpr float pi = 3.14159265358979f;

/// A world direction of the eye: right 0, up 1, toward it 2.
glm::vec3 eye_axis(const lumen::Camera& camera, int axis) { return glm::transpose(glm::mat3(camera.view))[axis]; }

/// Where a sphere is seen to end: a circle nearer than its middle, if seen in perspective. None from inside.
std::optional<Polyline> silhouette(const Shape& sphere, const lumen::Camera& camera) {
  glm::vec3 center = sphere.center, toward = eye_axis(camera, 2);
  float radius = sphere.radius;
  if (!camera.orthographic) {
    const glm::vec3 arm = glm::vec3(glm::inverse(camera.view)[3]) - sphere.center;
    const float distance = glm::length(arm);
    if (distance <= sphere.radius) return std::nullopt;
    const float sine = sphere.radius / distance;
    toward = arm / distance;
    center += toward * (sphere.radius * sine);
    radius *= std::sqrt(1 - sine * sine);
  }
  const glm::vec3 right = glm::normalize(glm::cross(eye_axis(camera, 1), toward)), up = glm::cross(toward, right);
  Polyline circle;
  for (int i = 0; i <= arc_steps; ++i) {
    const float angle = 2 * pi * float(i) / arc_steps;
    circle.push_back(center + radius * (std::cos(angle) * right + std::sin(angle) * up));
  }
  return circle;
}

Polyline arc(const Shape& shape, float from, float to, float z) {
  Polyline line;
  for (int i = 0; i <= arc_steps; ++i) {
    const float angle = from + (to - from) * float(i) / arc_steps;
    line.push_back(shape.world({shape.radius * std::cos(angle), shape.radius * std::sin(angle), z}));
  }
  return line;
}

glm::vec3 on_rim(const Shape& shape, float angle, float z) { return shape.world({shape.radius * std::cos(angle), shape.radius * std::sin(angle), z}); }

std::vector<Polyline> box_edges(const Shape& box) {
  std::vector<Polyline> edges;
  for (int axis = 0; axis < 3; ++axis)
    for (int corner = 0; corner < 4; ++corner) {
      glm::vec3 half = 0.5f * box.size;
      half[(axis + 1) % 3] *= corner & 1 ? 1.0f : -1.0f;
      half[(axis + 2) % 3] *= corner & 2 ? 1.0f : -1.0f;
      glm::vec3 other = half;
      other[axis] = -half[axis];
      edges.push_back({box.world(half), box.world(other)});
    }
  return edges;
}

/// Where along the line through `point` the ray comes nearest; nothing if they are parallel.
std::optional<float> along(glm::vec3 point, glm::vec3 direction, const Ray& ray) {
  const float between = glm::dot(direction, ray.direction), apart = 1 - between * between;
  if (apart < 1e-4f) return std::nullopt;
  const glm::vec3 arm = ray.origin - point;
  return (glm::dot(arm, direction) - between * glm::dot(arm, ray.direction)) / apart;
}

std::optional<glm::vec3> on_plane(glm::vec3 point, glm::vec3 normal, const Ray& ray) {
  const float speed = glm::dot(normal, ray.direction);
  if (std::abs(speed) < 1e-4f) return std::nullopt;
  return ray.origin + ray.direction * (glm::dot(normal, point - ray.origin) / speed);
}

/// Moves the side that lies in the handle's direction, and half of that way the center: the other side stays.
float pulled(Shape& shape, const Handle& handle, float length, float way) {
  const float next = std::max(length + way, 0.0f);
  shape.center += 0.5f * (next - length) * handle.direction;
  return next;
}

}  // namespace

std::vector<Handle> handles_of(const Shape& shape, const lumen::Camera& camera) {
  std::vector<Handle> handles = {{.grip = Handle::Grip::move, .place = shape.center}};
  const auto add = [&](Handle::Grip grip, glm::vec3 direction, float reach, int axis = 0) {
    handles.push_back({.grip = grip, .place = shape.center + reach * direction, .direction = direction, .axis = axis});
  };
  if (shape.kind == "sphere") {
    for (const float side : {1.0f, -1.0f})
      for (const int axis : {0, 1}) add(Handle::Grip::radius, side * eye_axis(camera, axis), shape.radius);
    return handles;
  }
  const glm::mat3 own = glm::mat3_cast(shape.rotation);
  if (shape.kind == "box") {
    for (const float side : {1.0f, -1.0f})
      for (int axis = 0; axis < 3; ++axis) add(Handle::Grip::size, side * own[axis], 0.5f * shape.size[axis], axis);
    return handles;
  }
  for (const float side : {1.0f, -1.0f}) add(Handle::Grip::length, side * own[2], 0.5f * shape.length);
  add(Handle::Grip::radius, own[0], shape.radius);
  if (shape.kind == "tube") {
    add(Handle::Grip::radius, -own[0], shape.radius);
    for (const float side : {1.0f, -1.0f}) add(Handle::Grip::radius, side * own[1], shape.radius);
    return handles;
  }
  for (const float side : {0.5f, -0.5f}) handles.push_back({.grip = Handle::Grip::angle, .place = on_rim(shape, side * glm::radians(shape.angle), 0)});
  return handles;
}

std::vector<Polyline> outlines_of(const Shape& shape, const lumen::Camera& camera) {
  std::vector<Polyline> lines;
  if (shape.kind == "sphere") {
    if (auto circle = silhouette(shape, camera)) lines.push_back(std::move(*circle));
    return lines;
  }
  if (shape.kind == "box") return box_edges(shape);
  const float end = 0.5f * shape.length, side = 0.5f * glm::radians(shape.angle);
  if (shape.kind == "tube") {
    for (const float z : {-end, end}) lines.push_back(arc(shape, 0, 2 * pi, z));
    for (int i = 0; i < 4; ++i) lines.push_back({on_rim(shape, 0.5f * pi * float(i), -end), on_rim(shape, 0.5f * pi * float(i), end)});
    return lines;
  }
  for (const float z : {-end, end}) {
    Polyline sector = arc(shape, -side, side, z);
    sector.push_back(shape.world({0, 0, z}));
    sector.push_back(sector.front());
    lines.push_back(std::move(sector));
  }
  for (const float angle : {-side, side}) lines.push_back({on_rim(shape, angle, -end), on_rim(shape, angle, end)});
  lines.push_back({shape.world({0, 0, -end}), shape.world({0, 0, end})});
  return lines;
}

Shape dragged(const Shape& shape, const Handle& handle, const Ray& from, const Ray& to, const lumen::Camera& camera) {
  Shape next = shape;
  if (handle.grip == Handle::Grip::move) {
    const auto before = on_plane(shape.center, eye_axis(camera, 2), from), after = on_plane(shape.center, eye_axis(camera, 2), to);
    if (before && after) next.center += *after - *before;
    return next;
  }
  if (handle.grip == Handle::Grip::angle) {
    const auto hit = on_plane(shape.center, shape.rotation * glm::vec3(0, 0, 1), to);
    if (!hit) return next;
    const glm::vec3 own = glm::conjugate(shape.rotation) * (*hit - shape.center);
    next.angle = std::min(2 * glm::degrees(std::abs(std::atan2(own.y, own.x))), 180.0f);
    return next;
  }
  const auto before = along(handle.place, handle.direction, from), after = along(handle.place, handle.direction, to);
  if (!before || !after) return next;
  const float way = *after - *before;
  if (handle.grip == Handle::Grip::radius) next.radius = std::max(shape.radius + way, 0.0f);
  if (handle.grip == Handle::Grip::length) next.length = pulled(next, handle, shape.length, way);
  if (handle.grip == Handle::Grip::size) next.size[handle.axis] = pulled(next, handle, shape.size[handle.axis], way);
  return next;
}

}  // namespace cut_volume
