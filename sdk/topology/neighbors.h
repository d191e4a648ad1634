/// Triangles that meet in an edge. For plugins that link lumen-topology.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include <lumen/mesh.h>

namespace lumen {

/// Across one edge.
struct Neighbor {
  static constexpr std::uint32_t none = 0xffffffff;
  std::uint32_t triangle = none;
  bool disagrees = false;  ///< both run along the edge in the same direction: they face opposite ways
};

/// Across edges of exactly two triangles; at borders, and where more meet, there is no neighbor.
class Neighbors {
 public:
  /// `corners_of`: of each triangle 0..count - 1, the numbers of its points.
  Neighbors(std::size_t count, const std::function<glm::uvec3(std::size_t)>& corners_of);

  /// Neighbor k lies across the edge from corner k to the next.
  const std::array<Neighbor, 3>& operator[](std::size_t triangle) const { return of_[triangle]; }
  std::size_t size() const { return of_.size(); }
  std::size_t border_edges() const { return border_edges_; }  ///< edges of one triangle

 private:
  std::vector<std::array<Neighbor, 3>> of_;
  std::size_t border_edges_ = 0;
};

/// Of each point, the first that has its position: by these numbers, seams of duplicated points do not tear the surface apart.
std::vector<std::uint32_t> merged_points(const Mesh& mesh);

}  // namespace lumen
