/// Closed shapes of several parts that fit into each other, and whether parts of them intersect, by brute force.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include <lumen/testing.h>

namespace explode_shapes {

using MeshPointer = std::shared_ptr<lumen::Mesh>;

/// The same shape with one point at a place, and without normals: its parts are connected.
inline MeshPointer welded(const lumen::Mesh& mesh) {
  auto result = std::make_shared<lumen::Mesh>();
  std::vector<glm::vec3> positions;
  std::vector<glm::uvec3> triangles;
  std::vector<std::uint32_t> number;
  for (const glm::vec3& position : mesh.positions) {
    const auto same = std::find(positions.begin(), positions.end(), position);
    number.push_back(std::uint32_t(same - positions.begin()));
    if (same == positions.end()) positions.push_back(position);
  }
  for (const glm::uvec3& t : mesh.triangles) triangles.emplace_back(number[t.x], number[t.y], number[t.z]);
  result->origin = "welded";
  result->positions = std::move(positions);
  result->triangles = std::move(triangles);
  result->finish();
  return result;
}
inline MeshPointer box(glm::vec3 size, glm::vec3 center = glm::vec3(0)) { return lumen::testing::moved(*welded(*lumen::testing::box(size)), center); }
inline MeshPointer ball(float radius, glm::vec3 center = glm::vec3(0)) { return lumen::testing::moved(*welded(*lumen::testing::sphere(12, radius)), center); }

/// A closed outline of (radius, z), counterclockwise in that plane, turned about z. Radii above 0.
inline MeshPointer turned(const std::vector<glm::vec2>& outline, int around = 16) {
  auto mesh = std::make_shared<lumen::Mesh>();
  std::vector<glm::vec3> positions;
  std::vector<glm::uvec3> triangles;
  const auto count = std::uint32_t(outline.size());
  for (int i = 0; i < around; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.3) / around;
    for (const glm::vec2& point : outline) positions.emplace_back(point.x * std::cos(angle), point.x * std::sin(angle), point.y);
  }
  for (std::uint32_t i = 0; i < std::uint32_t(around); ++i)
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::uint32_t a = i * count + k, b = i * count + (k + 1) % count, next = (i + 1) % std::uint32_t(around) * count;
      const std::uint32_t c = next + (k + 1) % count, d = next + k;
      triangles.emplace_back(a, d, c);
      triangles.emplace_back(a, c, b);
    }
  mesh->origin = "turned";
  mesh->positions = std::move(positions);
  mesh->triangles = std::move(triangles);
  mesh->finish();
  return mesh;
}

inline MeshPointer ring(float inner, float outer, float low, float high) { return turned({{inner, low}, {outer, low}, {outer, high}, {inner, high}}); }
inline MeshPointer rod(float radius, float low, float high) { return turned({{1e-3f, low}, {radius, low}, {radius, high}, {1e-3f, high}}); }

/// Boxes on each other, which touch.
inline MeshPointer stack(int count) {
  std::vector<MeshPointer> boxes;
  for (int i = 0; i < count; ++i) boxes.push_back(box({2, 1, 0.5f}, {0, 0, 0.5f * float(i)}));
  return lumen::testing::joined(boxes);
}
/// Part 0 a rod along z, 1.. rings around it.
inline MeshPointer rings_on_rod() { return lumen::testing::joined({rod(0.3f, -2, 2), ring(0.35f, 1, -1, -0.6f), ring(0.35f, 0.8f, -0.5f, 0), ring(0.35f, 1, 0.1f, 0.5f)}); }
/// Part 0 a bottle, 1 the cap over its neck, 2 a stick that stands in it and reaches into the cap, 3 a ball that does not fit through the neck.
inline MeshPointer bottle() {
  const MeshPointer body = turned({{1e-3f, -1.2f}, {1, -1.2f}, {1, 0.5f}, {0.4f, 0.8f}, {0.4f, 1.5f}, {0.3f, 1.5f}, {0.3f, 0.7f}, {0.9f, 0.4f}, {0.9f, -1.1f}, {1e-3f, -1.1f}});
  const MeshPointer cap = turned({{0.45f, 1}, {0.6f, 1}, {0.6f, 1.8f}, {1e-3f, 1.8f}, {1e-3f, 1.7f}, {0.45f, 1.7f}});
  return lumen::testing::joined({body, cap, rod(0.1f, -0.5f, 1.6f), ball(0.4f, {0.45f, 0, -0.6f})});
}
/// Balls in balls, and one beside them.
inline MeshPointer shells() { return lumen::testing::joined({ball(1), ball(0.7f), ball(0.4f), ball(0.5f, {1.8f, 0.1f, 0})}); }
/// A tray between walls, on a base, with two boxes on it under a lid.
inline MeshPointer drawer() {
  return lumen::testing::joined({box({0.8f, 0.6f, 0.3f}, {0.1f, 0, 0}), box({0.2f, 0.2f, 0.2f}, {-0.2f, 0, 0.3f}), box({0.2f, 0.2f, 0.2f}, {0.3f, 0, 0.3f}), box({1, 0.8f, 0.1f}, {0, 0, 0.5f}),
                                 box({0.1f, 0.8f, 0.6f}, {-0.6f, 0, 0.1f}), box({1.2f, 0.8f, 0.1f}, {0, 0, -0.3f}), box({1, 0.1f, 0.6f}, {0, -0.5f, 0.1f}), box({1, 0.1f, 0.6f}, {0, 0.5f, 0.1f})});
}
/// Part 0 a drawer that only comes out toward +x, 1 a bolt before it that only goes up; what holds both: 2 to 10.
inline MeshPointer bolted_drawer() {
  return lumen::testing::joined({box({1, 0.6f, 0.4f}), box({0.1f, 0.76f, 0.6f}, {0.57f, 0, 0.1f}), box({3, 1.4f, 0.1f}, {0.5f, 0, -0.26f}), box({1, 1.4f, 0.1f}, {0, 0, 0.26f}),
                                 box({1, 0.1f, 0.4f}, {0, 0.36f, 0}), box({1, 0.1f, 0.4f}, {0, -0.36f, 0}), box({0.1f, 0.8f, 0.4f}, {-0.56f, 0, 0}),
                                 box({0.1f, 0.18f, 0.4f}, {0.69f, 0.41f, 0}), box({0.1f, 0.18f, 0.4f}, {0.69f, -0.41f, 0}), box({0.12f, 0.1f, 0.4f}, {0.57f, 0.44f, 0}),
                                 box({0.12f, 0.1f, 0.4f}, {0.57f, -0.44f, 0})});
}
/// The faces of three boxes in a row, each face a part: what has no inside is in the way, too.
inline MeshPointer faces() {
  using lumen::testing::moved;
  const auto loose = [](glm::vec3 size, glm::vec3 center) { return moved(*lumen::testing::box(size), center); };
  return lumen::testing::joined({loose({0.8f, 0.6f, 0.3f}, {0, 0, 0}), loose({0.2f, 0.2f, 0.2f}, {0.1f, 0.05f, 0.4f}), loose({0.1f, 1, 0.9f}, {-0.6f, 0, 0.2f})});
}

using Triangle = std::array<glm::dvec3, 3>;

/// The triangles of each part of a split, as drawn.
inline std::vector<std::vector<Triangle>> drawn(const lumen::Mesh& mesh, const lumen::Split& split) {
  std::vector<std::vector<Triangle>> parts(split.parts.size());
  for (std::size_t part = 0; part < parts.size(); ++part)
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      if (int((*split.groups)[i]) != split.parts[part].group) continue;
      const auto at = [&](std::uint32_t point) { return glm::dvec3(split.parts[part].transform * glm::vec4(mesh.positions[point], 1)); };
      parts[part].push_back({at(mesh.triangles[i].x), at(mesh.triangles[i].y), at(mesh.triangles[i].z)});
    }
  return parts;
}

/// An edge of one goes through the other, by more than a contact.
inline bool pierces(const Triangle& one, const Triangle& other) {
  constexpr double least = 1e-4;
  const glm::dvec3 u = other[1] - other[0], v = other[2] - other[0], normal = glm::cross(u, v);
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 from = one[i], way = one[(i + 1) % 3] - from;
    const double steep = glm::dot(normal, way);
    if (std::abs(steep) < 1e-9 * glm::length(normal) * glm::length(way)) continue;
    const double along = glm::dot(normal, other[0] - from) / steep;
    const double margin = least / glm::length(way);
    if (along < margin || along > 1 - margin) continue;
    const glm::dvec3 at = from + along * way - other[0];
    const double area = glm::dot(normal, normal), b = glm::dot(glm::cross(at, v), normal) / area, c = glm::dot(glm::cross(u, at), normal) / area;
    if (b > least && c > least && b + c < 1 - least) return true;
  }
  return false;
}

inline lumen::Bounds box_of(std::span<const glm::dvec3> points) {
  lumen::Bounds bounds;
  for (const glm::dvec3& point : points) bounds.include(glm::vec3(point));
  return bounds;
}
inline bool apart(const lumen::Bounds& a, const lumen::Bounds& b) { return glm::any(glm::lessThan(a.max, b.min)) || glm::any(glm::lessThan(b.max, a.min)); }

inline bool intersect(const std::vector<Triangle>& a, const std::vector<Triangle>& b) {
  lumen::Bounds one, other;
  for (const Triangle& triangle : a) one.include(box_of(triangle));
  for (const Triangle& triangle : b) other.include(box_of(triangle));
  for (const Triangle& s : a) {
    if (apart(box_of(s), other)) continue;
    for (const Triangle& t : b)
      if (!apart(box_of(t), one) && (pierces(s, t) || pierces(t, s))) return true;
  }
  return false;
}

}  // namespace explode_shapes
