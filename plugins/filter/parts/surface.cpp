#include "surface.h"

#include <glm/geometric.hpp>
#include <topology/orientation.h>

namespace {

std::vector<bool> facing_inward(const lumen::Mesh& mesh) {
  std::vector<bool> turned = lumen::orientation_of(mesh).turned;
  turned.resize(mesh.triangles.size(), false);
  return turned;
}

std::vector<glm::uvec3> outward(const lumen::Mesh& mesh, const std::vector<bool>& turned) {
  std::vector<glm::uvec3> triangles(mesh.triangles.begin(), mesh.triangles.end());
  for (std::size_t i = 0; i < triangles.size(); ++i)
    if (turned[i]) std::swap(triangles[i].y, triangles[i].z);
  return triangles;
}

lumen::Neighbors across_edges(const std::vector<glm::uvec3>& triangles) {
  return {triangles.size(), [&](std::size_t i) { return triangles[i]; }};
}

}  // namespace

Surface::Surface(const lumen::Mesh& mesh) : positions_(mesh.positions), turned_(facing_inward(mesh)), triangles_(outward(mesh, turned_)), neighbors_(across_edges(triangles_)) {
  if (neighbors_.border_edges() > 0) {  // an open seam of doubled points does not end the surface
    const std::vector<std::uint32_t> place = lumen::merged_points(mesh);
    for (glm::uvec3& t : triangles_) t = {place[t.x], place[t.y], place[t.z]};
    neighbors_ = across_edges(triangles_);
  }
  normals_ = lumen::average_normals(positions_, triangles_);
  areas_.reserve(size());
  for (const glm::uvec3& t : triangles_) {
    areas_.push_back(0.5f * glm::length(glm::cross(positions_[t.y] - positions_[t.x], positions_[t.z] - positions_[t.x])));
    area_ += areas_.back();
  }
}

glm::vec3 Surface::center(std::size_t triangle) const {
  const glm::uvec3& t = triangles_[triangle];
  return (positions_[t.x] + positions_[t.y] + positions_[t.z]) / 3.0f;
}

float Surface::edge_length(std::size_t triangle, int k) const {
  return glm::distance(positions_[triangles_[triangle][k]], positions_[triangles_[triangle][(k + 1) % 3]]);
}

glm::vec3 Surface::normal(std::size_t triangle) const {
  const glm::uvec3& t = triangles_[triangle];
  const glm::vec3 normal = glm::cross(positions_[t.y] - positions_[t.x], positions_[t.z] - positions_[t.x]);
  const float length = glm::length(normal);
  return length > 0 ? normal / length : glm::vec3(0);
}

glm::vec3 Surface::smooth_normal(std::size_t triangle) const {
  const glm::uvec3& t = triangles_[triangle];
  const glm::vec3 sum = normals_[t.x] + normals_[t.y] + normals_[t.z];
  const float length = glm::length(sum);
  return length > 0 ? sum / length : glm::vec3(0);
}
