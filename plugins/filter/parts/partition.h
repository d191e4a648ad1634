/// Triangles in parts: runs of one class, small ones absorbed, numbered by size.
#pragma once

#include <cstdint>
#include <vector>

#include "surface.h"

struct Partition {
  std::vector<std::uint32_t> of_triangle;  ///< 0..areas.size() - 1
  std::vector<double> areas;               ///< of the parts
};

/// What happens to connected pieces that are too small to be parts.
enum class Specks { keep, join, last };

Partition partition_of(const Surface& surface, std::vector<std::uint32_t> of_triangle);
/// Connected runs of triangles of the same class.
Partition runs_of(const Surface& surface, const std::vector<bool>& classes);
/// Parts of less than `smallest`, a share of the area, become of the neighbor with the longest common border, the smallest first.
Partition absorbed(const Surface& surface, Partition partition, double smallest);
/// The largest part is 0. Parts of less than `smallest` (they have no neighbors) stay, join the nearest part, or are all together the last one.
Partition numbered(const Surface& surface, const Partition& partition, double smallest, Specks specks);
