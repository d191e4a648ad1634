/// The view's surfaces as Embree holds them: split parts moved and clipped.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include <lumen/frame.h>

/// Immutable once built; occluded() may be called from many threads.
class RayScene {
 public:
  /// Throws Error if Embree fails (out of memory).
  explicit RayScene(std::vector<lumen::TracedSurface> surfaces);
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  std::size_t bytes() const;  ///< of triangles and hierarchy
  /// Whether these surfaces are what was built.
  bool shows(std::span<const lumen::TracedSurface> surfaces) const;
  /// Whether the ray from a world position along a unit direction hits anything nearer than `reach`, world units.
  bool occluded(glm::vec3 origin, glm::vec3 direction, float reach) const;

 private:
  void add_split(const lumen::TracedSurface& surface);
  struct Embree;
  std::unique_ptr<Embree> embree_;
  std::vector<lumen::TracedSurface> surfaces_;
};
