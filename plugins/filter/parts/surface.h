/// A mesh as one solid: its triangles turned outward, and what lies beside each.
#pragma once

#include <span>
#include <vector>

#include <lumen/mesh.h>
#include <topology/neighbors.h>

class Surface {
 public:
  explicit Surface(const lumen::Mesh& mesh);

  std::size_t size() const { return triangles_.size(); }
  std::span<const glm::vec3> positions() const { return positions_; }
  const glm::uvec3& corners(std::size_t triangle) const { return triangles_[triangle]; }
  const std::array<lumen::Neighbor, 3>& neighbors(std::size_t triangle) const { return neighbors_[triangle]; }
  /// Which corner of the mesh's triangle corner k is.
  int source_corner(std::size_t triangle, int k) const { return turned_[triangle] && k > 0 ? 3 - k : k; }
  glm::vec3 center(std::size_t triangle) const;
  float area(std::size_t triangle) const { return areas_[triangle]; }
  std::span<const float> areas() const { return areas_; }
  double area() const { return area_; }
  /// Of the edge that neighbor k shares.
  float edge_length(std::size_t triangle, int k) const;
  /// Outward, unit; zero for a triangle without area.
  glm::vec3 normal(std::size_t triangle) const;
  /// The mean of the normals of the corners.
  glm::vec3 smooth_normal(std::size_t triangle) const;
  std::size_t border_edges() const { return neighbors_.border_edges(); }  ///< 0: closed

 private:
  std::span<const glm::vec3> positions_;
  std::vector<bool> turned_;            ///< of each triangle, whether the mesh has it facing inward
  std::vector<glm::uvec3> triangles_;   ///< by the mesh's points or, if it is open by these, by places
  lumen::Neighbors neighbors_;
  std::vector<glm::vec3> normals_;      ///< of points
  std::vector<float> areas_;
  double area_ = 0;
};
