/// Which way the triangles of a mesh face. For plugins that link lumen-topology.
#pragma once

#include <vector>

#include <lumen/mesh.h>

namespace lumen {

struct Orientation {
  /// The surface encloses a solid, and faces out of it everywhere once the `turned` triangles are turned around: seen from
  /// outside, what faces away is hidden.
  bool solid = false;
  /// By triangle: it faces into the solid. Empty: none does, or there is no solid.
  std::vector<bool> turned = {};
};

Orientation orientation_of(const Mesh& mesh);

}  // namespace lumen
