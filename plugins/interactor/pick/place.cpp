#include "place.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace pick {
namespace {

/// Of a point's projection onto the triangle's plane; of one without area its first corner.
glm::dvec3 barycentric(const lumen::Mesh& mesh, const glm::uvec3& triangle, glm::dvec3 point) {
  const glm::dvec3 a(mesh.positions[triangle.x]), b(mesh.positions[triangle.y]), c(mesh.positions[triangle.z]), ab = b - a, ac = c - a, ap = point - a;
  const glm::dvec3 normal = glm::cross(ab, ac);
  const double square = glm::dot(normal, normal);
  if (!(square > 0)) return {1, 0, 0};
  const double of_b = glm::dot(glm::cross(ap, ac), normal) / square, of_c = glm::dot(glm::cross(ab, ap), normal) / square;
  return {1 - of_b - of_c, of_b, of_c};
}

double least(glm::dvec3 v) { return std::min({v.x, v.y, v.z}); }

struct Corners {
  glm::uvec3 points;
  glm::dvec3 weights;  ///< 0..1, their sum is 1
};

/// In the triangle of the cell that holds the point, or comes closest to that.
Corners corners_at(const lumen::Mesh& mesh, std::size_t first, int cell, glm::dvec3 point) {
  Corners best{mesh.triangles[first], barycentric(mesh, mesh.triangles[first], point)};
  if (!mesh.triangle_cells.empty())
    for (std::size_t i = first + 1; i < mesh.triangles.size(); ++i) {
      if (mesh.triangle_cells[i] != std::uint32_t(cell)) continue;
      const glm::dvec3 weights = barycentric(mesh, mesh.triangles[i], point);
      if (least(weights) > least(best.weights)) best = {mesh.triangles[i], weights};
    }
  best.weights = glm::max(best.weights, glm::dvec3(0));
  best.weights /= best.weights.x + best.weights.y + best.weights.z;
  return best;
}

std::string text_of(const std::vector<double>& tuple) {
  std::string text;
  for (const double value : tuple) {
    char number[32];
    std::snprintf(number, sizeof number, "%.6g", value);
    text += (text.empty() ? "" : ", ") + std::string(number);
  }
  return tuple.size() == 1 ? text : "(" + text + ")";
}

}  // namespace

int part_around(const lumen::Mesh& mesh, const lumen::Grouping& parts, glm::vec3 point) {
  std::vector<double> angles(parts.count, 0.0), volumes(parts.count, 0.0);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const glm::uvec3& triangle = mesh.triangles[i];
    const auto arm = [&](std::uint32_t corner) { return glm::dvec3(mesh.positions[corner]) - glm::dvec3(point); };
    const glm::dvec3 a = arm(triangle.x), b = arm(triangle.y), c = arm(triangle.z);
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c), volume = glm::dot(a, glm::cross(b, c));
    angles[parts.of_triangle[i]] += 2 * std::atan2(volume, la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
    volumes[parts.of_triangle[i]] += volume;
  }
  int innermost = -1;
  for (int part = 0; part < int(parts.count); ++part) {
    const bool encloses = std::abs(angles[std::size_t(part)]) > 2 * std::numbers::pi;
    if (encloses && (innermost < 0 || std::abs(volumes[std::size_t(part)]) < std::abs(volumes[std::size_t(innermost)]))) innermost = part;
  }
  return innermost;
}

std::vector<std::string> values_at(const lumen::Mesh& mesh, int cell, glm::vec3 point) {
  std::vector<std::string> values;
  const std::int64_t first = lumen::triangle_of_cell(mesh, cell);
  if (first < 0) return values;
  const Corners corners = corners_at(mesh, std::size_t(first), cell, point);
  for (const lumen::Attribute& attribute : mesh.attributes) {
    std::vector<double> tuple;
    const std::size_t components = std::size_t(attribute.components);
    for (std::size_t c = 0; c < components; ++c) {
      const auto of = [&](std::size_t index) { return double(attribute.values[index * components + c]); };
      if (attribute.on == lumen::Attribute::On::cells) tuple.push_back(of(std::size_t(cell)));
      else tuple.push_back(glm::dot(corners.weights, glm::dvec3(of(corners.points.x), of(corners.points.y), of(corners.points.z))));
    }
    values.push_back(attribute.name + " = " + text_of(tuple));
  }
  return values;
}

}  // namespace pick
