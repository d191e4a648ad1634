/// Whether a mesh is closed and turned outward.
#pragma once

#include <cstdint>
#include <unordered_map>

#include <glm/geometric.hpp>
#include <lumen/mesh.h>

namespace lumenshop {

/// Directed edges that are not matched by exactly one edge of the opposite direction: 0 = closed and consistently oriented.
inline std::size_t open_edges(const lumen::Mesh& mesh) {
  std::unordered_map<std::uint64_t, int> edges;
  edges.reserve(mesh.triangles.size() * 3);
  for (const glm::uvec3& triangle : mesh.triangles)
    for (int corner = 0; corner < 3; ++corner) ++edges[std::uint64_t{triangle[corner]} << 32 | triangle[(corner + 1) % 3]];
  std::size_t wrong = 0;
  for (const auto& [edge, uses] : edges) {
    const auto opposite = edges.find(edge << 32 | edge >> 32);
    wrong += uses != 1 || opposite == edges.end();
  }
  return wrong;
}

inline double volume(const lumen::Mesh& mesh) {
  double six = 0;
  for (const glm::uvec3& t : mesh.triangles)
    six += glm::dot(glm::dvec3(mesh.positions[t.x]), glm::cross(glm::dvec3(mesh.positions[t.y]), glm::dvec3(mesh.positions[t.z])));
  return six / 6;
}

}  // namespace lumenshop
