/// Where a few highlights show most of how a surface bends: the directions of lights.
#pragma once

#include <vector>

#include <glm/glm.hpp>
#include <lumen/camera.h>
#include <lumen/mesh.h>

/// Some of a surface's points, in world space.
struct CurvedPoints {
  std::vector<glm::vec3> positions, normals;  ///< normals unit
  std::vector<float> weights;                 ///< how much it bends there, >= 0
};

/// At most `most` points of the mesh. Weights are the magnitudes of its point array mean_curvature, the largest hundredth of them as one;
/// without that array all are 1. Empty if the mesh has no normals.
CurvedPoints curved_points(const lumen::Mesh& mesh, const glm::mat4& object_to_world, std::size_t most);

/// Directions toward at most `lights` lights, world, unit, the one of the most bent patch first: what faces the camera is divided into patches
/// of like normals, weighted by how much they bend, and each light is where its highlight falls on the middle of its patch, but at most `widest` radians
/// away from the eye's direction there. Empty if nothing that bends faces the camera.
std::vector<glm::vec3> highlight_directions(const CurvedPoints& points, const lumen::Camera& camera, int lights, float widest);
