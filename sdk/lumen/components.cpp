#include <lumen/components.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <lumen/error.h>

namespace lumen {

Grouping connected_parts(const Mesh& mesh) {
  std::vector<std::uint32_t> parent(mesh.positions.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const glm::uvec3& triangle : mesh.triangles) {
    const std::uint32_t a = root(triangle.x);
    parent[root(triangle.y)] = a;
    parent[root(triangle.z)] = a;
  }
  constexpr std::uint32_t unnumbered = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(mesh.positions.size(), unnumbered);
  Grouping grouping;
  grouping.of_triangle.reserve(mesh.triangles.size());
  for (const glm::uvec3& triangle : mesh.triangles) {
    std::uint32_t& group = number[root(triangle.x)];
    if (group == unnumbered) group = grouping.count++;
    grouping.of_triangle.push_back(group);
  }
  return grouping;
}

Grouping groups_by(const Mesh& mesh, const Attribute& attribute) {
  constexpr std::size_t most = 65536;
  const auto components = std::size_t(attribute.components);
  std::vector<float> of_triangle;
  of_triangle.reserve(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::size_t cell = mesh.triangle_cells.empty() ? i : mesh.triangle_cells[i];
    of_triangle.push_back(attribute.values[components * (attribute.on == Attribute::On::points ? mesh.triangles[i].x : cell)]);
  }
  const auto before = [](float a, float b) { return std::isnan(b) ? !std::isnan(a) : a < b; };
  const auto same = [](float a, float b) { return a == b || (std::isnan(a) && std::isnan(b)); };
  Grouping grouping{.values = of_triangle};
  std::sort(grouping.values.begin(), grouping.values.end(), before);
  grouping.values.erase(std::unique(grouping.values.begin(), grouping.values.end(), same), grouping.values.end());
  if (grouping.values.size() > most)
    throw Error("array '" + attribute.name + "'", "it has more than 65536 different values", "group by an array of labels");
  grouping.count = std::uint32_t(grouping.values.size());
  grouping.of_triangle.reserve(of_triangle.size());
  for (const float value : of_triangle)
    grouping.of_triangle.push_back(std::uint32_t(std::lower_bound(grouping.values.begin(), grouping.values.end(), value, before) - grouping.values.begin()));
  return grouping;
}

Grouping parts_of(const Mesh& mesh) {
  const Attribute* attribute = mesh.attribute(part_array);
  return attribute != nullptr ? groups_by(mesh, *attribute) : connected_parts(mesh);
}

std::int64_t triangle_of_cell(const Mesh& mesh, int cell) {
  if (cell < 0) return -1;
  if (mesh.triangle_cells.empty()) return std::size_t(cell) < mesh.triangles.size() ? cell : -1;
  const auto found = std::find(mesh.triangle_cells.begin(), mesh.triangle_cells.end(), std::uint32_t(cell));
  return found == mesh.triangle_cells.end() ? -1 : found - mesh.triangle_cells.begin();
}

}  // namespace lumen
