/// The membrane between true and false lumen: a thin closed slab with torn openings.
#pragma once

#include "anatomy.h"
#include "shell.h"

struct FlapOptions {
  float tear = 18;        ///< length of the entry tear, millimeters; 0 = none
  float thickness = 1.2f; ///< millimeters
};

class Flap {
 public:
  Flap(const Anatomy& anatomy, const FlapOptions& options);

  /// Triangles of a slab with cells of about `edge` millimeters, holes apart.
  std::size_t estimate(float edge) const;
  /// Appends the slab: watertight, counterclockwise from outside, smooth normals.
  void add(Shell& shell, float edge, const Progress& progress) const;

 private:
  struct Hole {
    glm::vec2 center, radii;  ///< arc length from the slab's begin; across, from the middle. Millimeters.
  };
  struct Point {
    glm::vec3 position, normal;
    float radius;
  };
  float half_width(float distance) const;
  Point point(float distance, float across) const;  ///< across: -1..1

  const Anatomy& anatomy_;
  FlapOptions options_;
  float begin_, end_, mean_half_width_;
  std::vector<Hole> holes_;
};
