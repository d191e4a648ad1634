#include "pieces.h"

#include <algorithm>
#include <numeric>

#include <lumen/components.h>

#include "../torn_groups.h"

namespace {

lumen::Grouping grouping_of(const lumen::Mesh& mesh, const std::string& array) {
  if (array.empty()) return lumen::parts_of(mesh);
  const lumen::Attribute* attribute = mesh.attribute(array);
  if (attribute == nullptr) throw lumen::Error("array '" + array + "'", "'" + mesh.origin + "' has no such array", "leave group_by empty for the mesh's own parts");
  return lumen::groups_by(mesh, *attribute);
}

/// All but the `most` - 1 of most triangles get one number, the smallest of theirs: it, or -1 if nothing was too many.
int leave_together(lumen::Grouping& grouping, std::size_t most) {
  if (grouping.count <= most) return -1;
  std::vector<std::size_t> size(grouping.count, 0);
  for (const std::uint32_t number : grouping.of_triangle) ++size[number];
  std::vector<std::uint32_t> order(grouping.count);
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return size[a] > size[b]; });
  const auto small = order.begin() + std::ptrdiff_t(most - 1);
  const std::uint32_t rest = *std::min_element(small, order.end());
  std::vector<std::uint32_t> number(grouping.count, rest);
  for (auto large = order.begin(); large != small; ++large) number[*large] = *large;
  for (std::uint32_t& group : grouping.of_triangle) group = number[group];
  return int(rest);
}

void measure(Piece& piece) {
  glm::dvec3 sum(0);
  double total = 0;
  for (const Corners& corners : piece.triangles) {
    const double area = 0.5 * double(glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0])));
    for (const glm::vec3& corner : corners) piece.bounds.include(corner);
    sum += area / 3 * (glm::dvec3(corners[0]) + glm::dvec3(corners[1]) + glm::dvec3(corners[2]));
    total += area;
  }
  piece.center = total > 0 ? glm::vec3(sum / total) : piece.bounds.center();
  piece.area = float(total);
}

}  // namespace

bool PiecesAsked::same(const PiecesAsked& other) const {
  return !mesh.owner_before(other.mesh) && !other.mesh.owner_before(mesh) && object_to_world == other.object_to_world && group_by == other.group_by;
}

Pieces::Pieces(PiecesAsked what) : asked(std::move(what)) {
  const auto mesh = asked.mesh.lock();
  if (mesh == nullptr) return;
  lumen::Grouping grouping = grouping_of(*mesh, asked.group_by);
  const int rest = leave_together(grouping, most);
  numbers = int(grouping.count);

  std::vector<glm::vec3> world;
  world.reserve(mesh->positions.size());
  for (const glm::vec3& position : mesh->positions) world.push_back(glm::vec3(asked.object_to_world * glm::vec4(position, 1)));
  std::vector<std::size_t> size(grouping.count, 0);
  for (const std::uint32_t number : grouping.of_triangle) ++size[number];
  std::vector<int> index(grouping.count, -1);
  for (std::uint32_t number = 0; number < grouping.count; ++number) {
    if (size[number] == 0) continue;
    index[number] = int(list.size());
    if (int(number) == rest) left_together = int(list.size());
    list.push_back({.number = int(number)});
    list.back().triangles.reserve(size[number]);
  }
  for (std::size_t i = 0; i < mesh->triangles.size(); ++i) {
    const glm::uvec3& triangle = mesh->triangles[i];
    list[std::size_t(index[grouping.of_triangle[i]])].triangles.push_back({world[triangle.x], world[triangle.y], world[triangle.z]});
  }
  lumen::Bounds bounds;
  float area = 0;
  for (Piece& piece : list) {
    measure(piece);
    bounds.include(piece.bounds);
    area += piece.area;
  }
  for (Piece& piece : list) piece.share = area > 0 ? piece.area / area : 0;
  radius = bounds.radius();
  if (!bounds.empty()) center = bounds.center();
  const std::vector<bool> torn = torn_groups(*mesh, grouping.of_triangle, grouping.count);
  for (Piece& piece : list) piece.torn = torn[std::size_t(piece.number)];
  groups = std::make_shared<const std::vector<std::uint32_t>>(std::move(grouping.of_triangle));
}
