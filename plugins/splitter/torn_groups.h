/// Groups of triangles that hang together: once apart, one sees into them where they did.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <lumen/mesh.h>

/// Of each group 0..count - 1, whether it shares a point with another. `groups`: one of each triangle.
inline std::vector<bool> torn_groups(const lumen::Mesh& mesh, std::span<const std::uint32_t> groups, std::uint32_t count) {
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::vector<bool> torn(count, false);
  std::vector<std::uint32_t> first(mesh.positions.size(), none);
  for (std::size_t i = 0; i < groups.size(); ++i)
    for (int corner = 0; corner < 3; ++corner) {
      std::uint32_t& group = first[mesh.triangles[i][corner]];
      if (group == none) group = groups[i];
      if (group != groups[i]) torn[group] = torn[groups[i]] = true;
    }
  return torn;
}
