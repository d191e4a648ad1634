/// Seams between parts, moved to where they are short and lie in folds.
#pragma once

#include <functional>
#include <span>

#include "partition.h"

/// Each seam between two parts may move by `reach`, in local thickness, to where the surface is cut at the least cost: its length, less where
/// the surface is concave, by the minima rule. `progress` gets 0..1 and may throw.
/// Katz, Tal, Hierarchical Mesh Decomposition Using Fuzzy Clustering and Cuts, ACM Trans. Graphics 22(3), 2003.
Partition with_best_seams(const Surface& surface, Partition partition, std::span<const float> thickness, float reach, const std::function<void(float)>& progress);
