/// Triangles under construction: one closed surface after the other.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <lumen/mesh.h>

/// Says how many of the triangles are made (0..1); may throw to stop.
using Progress = std::function<void(float)>;

struct Shell {
  std::vector<glm::vec3> positions, normals;   ///< millimeters; unit, outward
  std::vector<glm::uvec3> triangles;           ///< counterclockwise from outside
  std::vector<float> radius, pressure;         ///< per point: millimeters from the centerline; mmHg

  void reserve(std::size_t triangle_count);
  std::uint32_t add(glm::vec3 position, float distance, float mmhg);
  void append(const Shell& other);
};

/// A mesh of it with the point arrays `radius` and `pressure`; the shell is used up.
std::shared_ptr<lumen::Mesh> mesh_of(Shell shell, const std::string& origin);
