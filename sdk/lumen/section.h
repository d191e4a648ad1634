/// The faces that planes cut out of closed meshes. For plugins that link lumen-section.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <lumen/mesh.h>

namespace lumen {

/// Closed polylines in one plane, each as its points in order.
using Outlines = std::vector<std::vector<glm::vec3>>;

/// What outlines enclose, in triangles: where they wind around a point in sum at least once, in either direction.
struct Filling {
  std::vector<glm::vec3> positions;   ///< those of the outlines, in order; then points where outlines cross
  std::vector<glm::uvec3> triangles;  ///< counterclockwise about the normal
};
/// `normal`: of the plane, unit. Throws Error if the outlines cannot be filled.
Filling fill(const Outlines& outlines, glm::vec3 normal);

/// Where a plane cuts a mesh.
struct Section {
  bool closed = true;       ///< every line of it ends where another begins: the mesh has no border at the plane
  Outlines outlines;        ///< world; those that are closed, counterclockwise about the plane's normal if the mesh is turned outward
};
/// `plane`: world, normal unit. With `groups`, one of each triangle, only the triangles of `group` count.
Section section_of(const Mesh& mesh, const glm::mat4& object_to_world, const glm::vec4& plane, std::span<const std::uint32_t> groups = {}, int group = -1);

/// Spheres (center, radius) that hold the outlines, at most `most` of them.
std::vector<glm::vec4> spheres_around(const Outlines& outlines, std::size_t most = 64);

}  // namespace lumen
