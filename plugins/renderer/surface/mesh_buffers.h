/// A mesh as the GL holds it.
#pragma once

#include <memory>
#include <string>

#include <lumen/gl/vertex_array.h>
#include <lumen/frame.h>
#include <lumen/mesh.h>

#include "clusters.h"
#include "coverage.h"

class MeshBuffers {
 public:
  /// `attribute`: the array that colors, or null; its magnitude if it has several components. `curvature`: the tensors at the
  /// points, six numbers each, or null.
  MeshBuffers(const lumen::Mesh& mesh, const lumen::Attribute* attribute, const lumen::Attribute* curvature, Groups groups);
  /// Whether they were made for these groups.
  bool made_for(const Groups& groups) const { return groups == groups_; }
  /// All triangles of a group (-1: all) of the mesh that it was made from, in one call, which tells their cells apart.
  void draw_group(const lumen::Mesh& mesh, int group, lumen::Draw& draw);
  /// What the visibility lets through, and, where the GL is software, the coverage: in few calls, since a call per run costs
  /// software GL more than the triangles.
  void draw(const Visibility& visibility, Coverage coverage);
  const ClusteredMesh& clusters() const { return clusters_; }

  std::uint32_t triangle_count() const { return clusters_.count; }

 private:
  void bind(const lumen::gl::Buffer& indices) const;
  void draw_runs();
  void draw_covering(Coverage& coverage);
  void upload(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals, std::span<const float> values, std::span<const float> curvatures);
  Groups groups_;
  ClusteredMesh clusters_;
  bool software_;                   ///< the GL is
  lumen::gl::Buffer positions_, normals_, values_, curvatures_, triangles_;
  lumen::gl::Buffer cells_;         ///< made when first wanted
  lumen::gl::Buffer visible_;       ///< the triangles that draw() gathered last
  std::vector<SeenCluster> seen_;
  std::vector<Run> runs_;
  lumen::gl::VertexArray array_;
};

/// The numbers of an array that are shown: the values, or the magnitudes of vectors.
std::vector<float> shown_values(const lumen::Attribute& attribute);
