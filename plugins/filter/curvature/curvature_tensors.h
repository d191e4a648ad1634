/// How a surface bends at each of its points.
#pragma once

#include <functional>
#include <vector>

#include <glm/mat3x3.hpp>

#include "welded_surface.h"

struct CurvatureTensors {
  /// By point of the welded surface: symmetric, tangential, such that the normal curvature along a unit tangent w is w^T C w;
  /// positive where the surface bends away from its normal. 1 / object space; zero where it is unknown.
  std::vector<glm::mat3> tensors;
  std::size_t unknown = 0;   ///< points of triangles at which it could not be found
};

/// `smoothing`: how often each tensor becomes the mean of itself and its neighbors'. `progress` gets 0..1 and may throw.
CurvatureTensors curvature_of(const WeldedSurface& surface, int smoothing, const std::function<void(float)>& progress);
