/// Parts of a surface that are inside out.
#pragma once

#include <functional>
#include <vector>

#include "welded_surface.h"

/// By point: it belongs to a closed part that faces inward although nothing encloses it, as segmentations have them; a closed part
/// within another is a cavity. `progress` gets 0..1 and may throw.
std::vector<bool> inward_points(const WeldedSurface& surface, const std::function<void(float)>& progress);
