/// A surface whose seams are closed: points that lie at one place are one, unless a crease runs between them.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <glm/vec3.hpp>
#include <lumen/mesh.h>

struct WeldedSurface {
  std::vector<std::uint32_t> number;   ///< by point of the mesh: which point of this it is
  std::vector<glm::dvec3> positions;   ///< about the center of the mesh's box, in `unit`: near 0, at most 1
  std::vector<glm::dvec3> normals;     ///< unit; zero where triangles leave none
  std::vector<glm::uvec3> triangles;   ///< in the mesh's order
  double unit = 1;                     ///< object space
};

/// Points at one place whose normals differ by more than `crease` radians stay apart. A mesh without normals gets those of
/// its triangles, and has no creases. `progress` gets 0..1 and may throw.
WeldedSurface welded(const lumen::Mesh& mesh, double crease, const std::function<void(float)>& progress);
