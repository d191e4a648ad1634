/// A surface taken apart where more than two triangles meet in an edge, or only in a point, and turned one way: a manifold, for
/// half-edges. After Gueziec, Taubin, Lazarus, Horn, Cutting and Stitching: Converting Sets of Polygons to Manifold Surfaces, IEEE
/// TVCG 7(2), 2001.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

struct Sheets {
  std::vector<glm::uvec3> triangles;    ///< of the mesh's points and the copies
  std::vector<std::uint32_t> sources;   ///< which of the given triangles each is, ascending
  std::vector<std::uint32_t> copies;    ///< which point of the mesh each is, numbered after those
  std::size_t turned = 0;               ///< triangles whose corners run the other way than in the mesh
};

/// Two triangles of the same corners enclose nothing: both are left out, or one if the other is needed for a closed surface.
/// Triangles that meet in twos stay together. Where more meet, those that enclose the least space do. Of the triangles that hang
/// together, those of the smaller area are turned. The triangles have three different corners.
Sheets sheets_of(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles);
