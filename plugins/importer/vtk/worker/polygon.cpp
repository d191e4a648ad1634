/// Convex polygons as fans, others by ear clipping in the plane of their Newell normal.
#include "polygon.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace {

double turn(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

bool inside(glm::dvec2 point, glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
  return turn(a, b, point) >= 0 && turn(b, c, point) >= 0 && turn(c, a, point) >= 0;
}

}  // namespace

void PolygonCutter::cut(std::span<const glm::vec3> points, std::span<const std::uint32_t> corners, std::vector<glm::uvec3>& triangles) {
  const std::size_t count = corners.size();
  const auto fan = [&] {
    for (std::size_t corner = 1; corner + 1 < count; ++corner) triangles.emplace_back(corners[0], corners[corner], corners[corner + 1]);
  };
  if (count == 3) return fan();

  glm::dvec3 normal(0);
  const glm::dvec3 origin = points[corners[0]];
  for (std::size_t corner = 0; corner < count; ++corner)
    normal += glm::cross(glm::dvec3(points[corners[corner]]) - origin, glm::dvec3(points[corners[(corner + 1) % count]]) - origin);
  const double length = glm::length(normal);
  if (!(length > 0)) return fan();
  normal /= length;
  const glm::dvec3 helper = std::abs(normal.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 right = glm::normalize(glm::cross(helper, normal)), up = glm::cross(normal, right);

  flat_.resize(count);
  for (std::size_t corner = 0; corner < count; ++corner) {
    const glm::dvec3 offset = glm::dvec3(points[corners[corner]]) - origin;
    flat_[corner] = {glm::dot(offset, right), glm::dot(offset, up)};
  }
  bool convex = true;
  for (std::size_t corner = 0; corner < count && convex; ++corner)
    convex = turn(flat_[corner], flat_[(corner + 1) % count], flat_[(corner + 2) % count]) >= 0;
  if (!convex) return clip_ears(corners, triangles);
  // The shorter diagonal of a quad: warped quads crease less.
  if (count == 4 && glm::length(flat_[1] - flat_[3]) < glm::length(flat_[0] - flat_[2])) {
    triangles.emplace_back(corners[0], corners[1], corners[3]);
    triangles.emplace_back(corners[1], corners[2], corners[3]);
    return;
  }
  fan();
}

void PolygonCutter::clip_ears(std::span<const std::uint32_t> corners, std::vector<glm::uvec3>& triangles) {
  const auto count = static_cast<std::uint32_t>(corners.size());
  next_.resize(count);
  previous_.resize(count);
  for (std::uint32_t corner = 0; corner < count; ++corner) {
    next_[corner] = (corner + 1) % count;
    previous_[corner] = (corner + count - 1) % count;
  }
  const auto is_ear = [&](std::uint32_t corner) {
    const glm::dvec2 a = flat_[previous_[corner]], b = flat_[corner], c = flat_[next_[corner]];
    if (turn(a, b, c) <= 0) return false;
    for (std::uint32_t other = next_[next_[corner]]; other != previous_[corner]; other = next_[other]) {
      const glm::dvec2 point = flat_[other];
      // Only a reflex corner can lie in an ear; corners repeated at its ends (bridges to holes) do not count.
      if (turn(flat_[previous_[other]], point, flat_[next_[other]]) < 0 && point != a && point != b && point != c && inside(point, a, b, c)) return false;
    }
    return true;
  };
  std::uint32_t corner = 0, left = count, rejected = 0;
  // A polygon that crosses itself runs out of ears, and the search among very many corners is quadratic: then cut blindly.
  bool blind = count > 10000;
  while (left > 3) {
    if (!blind && !is_ear(corner)) {
      corner = next_[corner];
      blind = ++rejected > left;
      continue;
    }
    triangles.emplace_back(corners[previous_[corner]], corners[corner], corners[next_[corner]]);
    next_[previous_[corner]] = next_[corner];
    previous_[next_[corner]] = previous_[corner];
    corner = next_[next_[corner]];
    --left;
    rejected = 0;
  }
  triangles.emplace_back(corners[previous_[corner]], corners[corner], corners[next_[corner]]);
}
