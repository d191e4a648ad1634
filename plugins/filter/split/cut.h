/// A mesh cut by a plane: each triangle lies on one side of it, and both sides share the points of the cut.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <lumen/mesh.h>

enum class Side : std::uint8_t { above, below, whole };

/// Where a point of the cut comes from: `share` of the way between two points of the mesh.
struct Origin {
  std::uint32_t from = 0, to = 0;
  float share = 0;
};

/// A closed line of the cut: the border of what lies above, in the direction of its triangles.
struct Loop {
  std::vector<std::uint32_t> points;
  std::uint32_t triangle = 0;           ///< of the cut, beside it
};

struct Cut {
  std::vector<Origin> added;            ///< points beyond those of the mesh, numbered after them
  std::vector<glm::uvec3> triangles;    ///< of the mesh's points and the added ones
  std::vector<std::uint32_t> sources;   ///< which triangle of the mesh each one is, or is a piece of
  std::vector<Side> sides;              ///< of each triangle
  std::vector<Loop> loops;
  bool closed = true;                   ///< every line of the cut ends where it begins
  std::size_t border_edges = 0;         ///< of the mesh
  std::size_t parted = 0, turned = 0, doubles = 0;  ///< points doubled, triangles turned and left out where the mesh is no manifold
  std::size_t unfit = 0;                ///< triangles that fit no manifold even so: each stands alone

  Origin origin(std::uint32_t point, std::size_t mesh_points) const { return point < mesh_points ? Origin{point, point, 0} : added[point - mesh_points]; }
};

/// Cuts by `plane`: in the mesh's space, scaled so that distances are those of the world. A point within a rounding error of it
/// is itself a point of the cut; other points on the positive side are above. A triangle that lies in the plane goes with the
/// solid that it bounds. `whole`: of each triangle, whether its connected part is left alone; empty: none is.
/// `progress` gets 0..1 and may throw.
Cut cut(const lumen::Mesh& mesh, const glm::dvec4& plane, const std::vector<bool>& whole, const std::function<void(float)>& progress);
