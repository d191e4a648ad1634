/// Polygons become triangles.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

/// Cuts one polygon, convex or not, into size - 2 triangles of the same orientation.
class PolygonCutter {
 public:
  /// Appends triangles of indices taken from `corners`. Three corners or more, all valid indices into `points`.
  void cut(std::span<const glm::vec3> points, std::span<const std::uint32_t> corners, std::vector<glm::uvec3>& triangles);

 private:
  void clip_ears(std::span<const std::uint32_t> corners, std::vector<glm::uvec3>& triangles);

  // Kept between polygons to save the allocations.
  std::vector<glm::dvec2> flat_;
  std::vector<std::uint32_t> next_, previous_;
};
