/// A triangle mesh.
#pragma once

#include <array>

#include <lumen/data.h>

namespace lumen {

/// Indexed triangles, counterclockwise from outside. All arrays are checked by `finish`.
struct Mesh : Data {
  Array<glm::vec3> positions;               ///< object space; finite
  Array<glm::vec3> normals;                 ///< one per position, unit or zero; empty = none
  Array<glm::vec2> texture_coordinates;     ///< one per position; empty = none
  Array<glm::uvec3> triangles;              ///< indices into positions
  Array<std::uint32_t> triangle_cells;      ///< which cell of the source a triangle came from; empty = its own number
  std::vector<Attribute> attributes;        ///< point tuples: one per position; cell tuples: one per source cell

  DataKind kind() const override { return DataKind::mesh; }
  std::size_t bytes() const override;
  Bounds bounds() const override;           ///< computed once by `finish`
  std::string summary() const override;
  const Attribute* attribute(std::string_view name) const;  ///< null if there is none

  /// Checks sizes, indices and finite positions, and computes the bounds. Throws Error naming `origin`.
  void finish();

 private:
  Bounds bounds_;
};

/// Area-weighted point normals.
std::vector<glm::vec3> average_normals(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles);

}  // namespace lumen
