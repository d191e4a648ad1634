/// Which triangles can cover the center of a pixel: of a large mesh, most are smaller than a pixel and cover none. Software GL
/// pays as much for the vertices and the setup of such a triangle as for one that is seen, and far more than finding out.
/// The idea is that of Wihlidal, Optimizing the Graphics Pipeline with Compute, GDC 2016, who culls small primitives on the GPU.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "clusters.h"

class Coverage {
 public:
  /// Draws into `size` pixels, the whole viewport. `reach`: the greatest world coordinate, or way from the eye, that vertices are
  /// computed from: the GL's rounding grows with it.
  Coverage(const glm::mat4& world_to_clip, const glm::mat4& object_to_world, glm::ivec2 size, float reach);

  /// Appends the triangles of the cluster that may cover a center; only those that may face the eye unless `backs`.
  /// `positions`, `triangles`: of the whole mesh, its points numbered by number_points().
  void gather(const Cluster& cluster, bool backs, const glm::vec3* positions, const glm::uvec3* triangles, std::vector<glm::uvec3>& kept);

 private:
  /// Where a point lands: pixels, and 1/w.
  struct Place {
    float x, y, inverse_w;
  };
  Place place_of(const glm::vec3& position) const {
    const float inverse = 1 / (row_w_.x * position.x + row_w_.y * position.y + row_w_.z * position.z + row_w_.w);
    return {(row_x_.x * position.x + row_x_.y * position.y + row_x_.z * position.z + row_x_.w) * inverse,
            (row_y_.x * position.x + row_y_.y * position.y + row_y_.z * position.z + row_y_.w) * inverse, inverse};
  }
  bool may_cover(const Place& a, const Place& b, const Place& c, bool backs) const;

  glm::vec4 row_x_, row_y_, row_w_;  ///< homogeneous pixels of an object-space position
  glm::vec2 size_;
  float rounding_;                   ///< pixels at w = 1 that the GL's own places may differ by
  std::vector<Place> places_;        ///< of the cluster's own points
};
