/// The view's surfaces as rays meet them: split parts moved and clipped.
#pragma once

#include <span>
#include <vector>

#include <lumen/frame.h>
#include <rays/ray_triangles.h>

/// Immutable once built; occluded() may be called from many threads.
class RayScene {
 public:
  /// Throws Error if memory does not suffice.
  explicit RayScene(std::vector<lumen::TracedSurface> surfaces);

  std::size_t bytes() const { return world_.bytes(); }  ///< of triangles and hierarchy
  /// Whether these surfaces are what was built.
  bool shows(std::span<const lumen::TracedSurface> surfaces) const;
  /// Whether the ray from a world position along a unit direction hits anything nearer than `reach`, world units.
  bool occluded(glm::vec3 origin, glm::vec3 direction, float reach) const { return world_.occluded(origin, direction, reach); }

 private:
  void add_split(const lumen::TracedSurface& surface);
  lumen::RayTriangles world_;
  std::vector<lumen::TracedSurface> surfaces_;
};
