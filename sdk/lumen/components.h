/// Triangles in groups: the parts of a mesh, connected or of equal values of an array.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <lumen/mesh.h>

namespace lumen {

struct Grouping {
  std::vector<std::uint32_t> of_triangle;  ///< 0..count - 1
  std::uint32_t count = 0;
  std::vector<float> values = {};          ///< of the array, by group, ascending; empty: connected parts
};

/// Connected parts, numbered in the order of their first triangles: triangles that share a point number are connected.
Grouping connected_parts(const Mesh& mesh);
/// Equal values of an array's first component; that of a triangle's first corner if the array is one of points. NaN is a
/// group of its own, the last. Throws Error if there are more than 65536 groups.
Grouping groups_by(const Mesh& mesh, const Attribute& attribute);

/// The array that says which part each triangle belongs to, where connection does not tell.
inline constexpr const char* part_array = "component";
/// The parts that people pick and that splitters keep or move: by the array `component` if the mesh has one, else connected ones.
/// Throws as groups_by.
Grouping parts_of(const Mesh& mesh);

/// The first triangle of a source cell, or -1.
std::int64_t triangle_of_cell(const Mesh& mesh, int cell);

}  // namespace lumen
