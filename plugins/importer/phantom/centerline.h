/// A smooth curve with a radius and a frame at each arc length.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

/// Right-handed: cross(right, up) = forward.
struct CurveFrame {
  glm::vec3 position, right, up, forward;
  float radius;
};

/// A cubic B-spline of positions and radii (millimeters). Its frames turn as little as can be along it, and do not flip.
class Centerline {
 public:
  /// Two control points (position, radius) or more; it begins at the first and ends at the last.
  explicit Centerline(std::span<const glm::vec4> controls);

  float length() const { return distance_.back(); }
  CurveFrame at(float distance) const;             ///< arc length, clamped to 0..length()
  float distance_at(float control) const;          ///< arc length where the curve is nearest to a control point, by its index

 private:
  std::vector<CurveFrame> samples_;
  std::vector<float> distance_;  ///< arc length of each sample
  std::size_t controls_;
};
