/// How thick a solid is behind each of its triangles. After Shapira, Shamir, Cohen-Or, Consistent Mesh Partitioning and Skeletonisation
/// using the Shape Diameter Function, The Visual Computer 24, 2008.
#pragma once

#include <functional>
#include <vector>

#include "surface.h"

struct ThicknessOptions {
  int rays = 24;               ///< of each sample
  float cone = 60;             ///< opening of the cone they fill, degrees
  std::size_t samples = 40000; ///< triangles that send rays, at most; the others follow the nearest
  int smoothing = 4;           ///< rounds over the neighbors of samples
};

/// Of each triangle, in the mesh's units; 0 where no ray finds another side. `progress` gets 0..1 and may throw.
///
/// A ray's length is divided by the cosine of its angle to the inward normal: the diameter of the ball that touches the surface where the ray
/// starts and goes through the place where it ends. So a ball is as thick as its diameter, whatever the cone.
std::vector<float> thickness_of(const Surface& surface, const ThicknessOptions& options, const std::function<void(float)>& progress);
