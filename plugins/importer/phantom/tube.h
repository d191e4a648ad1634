/// Closed tubes: rings around a centerline, with rounded ends.
#pragma once

#include <span>

#include <glm/vec2.hpp>

#include "centerline.h"
#include "shell.h"

/// The cross-section of a tube at each arc length, star-shaped around its center.
class CrossSection {
 public:
  virtual ~CrossSection() = default;
  /// Its mean radius, for choosing ring counts.
  virtual float mean_radius(const CurveFrame& frame, float distance) const = 0;
  /// The radius in each direction (unit, in the plane of right and up). Returns the center's offset in that plane.
  virtual glm::vec2 evaluate(const CurveFrame& frame, float distance, std::span<const glm::vec2> directions, std::span<float> radii) const = 0;
};

struct Tube {
  const Centerline* line = nullptr;
  const CrossSection* section = nullptr;
  float begin = 0, end = 0;                      ///< arc lengths
  float begin_rounding = 0.1f, end_rounding = 0.1f;  ///< of the mean radius there: 0 flat .. 1 half a sphere
  float pressure_begin = 120, pressure_end = 100;    ///< mmHg
};

/// How finely a tube is cut: 2 * around * rings triangles.
struct TubeGrid {
  int around = 0, rings = 0;
  std::size_t triangles() const { return 2 * static_cast<std::size_t>(around) * static_cast<std::size_t>(rings); }
};

/// Cells with sides of about `edge` millimeters; at least 4 x 4.
TubeGrid grid_of(const Tube& tube, float edge);

/// Appends the tube: watertight, counterclockwise from outside, with smooth normals.
void add_tube(Shell& shell, const Tube& tube, TubeGrid grid, const Progress& progress);
