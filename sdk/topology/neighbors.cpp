/// Edges found by sorting the sides of all triangles.
#include <topology/neighbors.h>

#include <algorithm>

#include <meshoptimizer.h>

namespace lumen {

Neighbors::Neighbors(std::size_t count, const std::function<glm::uvec3(std::size_t)>& corners_of) : of_(count) {
  struct Side {
    std::uint64_t edge;
    std::uint32_t triangle;
    std::uint8_t corner;
    bool upward;
  };
  std::vector<Side> sides;
  sides.reserve(3 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const glm::uvec3 t = corners_of(i);
    for (std::uint8_t k = 0; k < 3; ++k) {
      const std::uint64_t a = t[k], b = t[(k + 1) % 3];
      sides.push_back({std::min(a, b) << 32 | std::max(a, b), std::uint32_t(i), k, a < b});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.edge < b.edge; });
  for (std::size_t i = 0, end; i < sides.size(); i = end) {
    for (end = i; end < sides.size() && sides[end].edge == sides[i].edge;) ++end;
    border_edges_ += end - i == 1;
    if (end - i != 2) continue;
    const Side &a = sides[i], &b = sides[i + 1];
    const bool disagrees = a.upward == b.upward;
    of_[a.triangle][a.corner] = {b.triangle, disagrees};
    of_[b.triangle][b.corner] = {a.triangle, disagrees};
  }
}

std::vector<std::uint32_t> merged_points(const Mesh& mesh) {
  // Bits are compared: -0 becomes 0.
  std::vector<glm::vec3> positions;
  positions.reserve(mesh.positions.size());
  for (const glm::vec3& position : mesh.positions) positions.push_back(position + 0.0f);
  std::vector<std::uint32_t> place(positions.size());
  const std::size_t places = meshopt_generateVertexRemap(place.data(), nullptr, positions.size(), positions.data(), positions.size(), sizeof(glm::vec3));
  std::vector<std::uint32_t> first(places, Neighbor::none);
  for (std::uint32_t point = 0; point < place.size(); ++point) {
    std::uint32_t& known = first[place[point]];
    if (known == Neighbor::none) known = point;
    place[point] = known;
  }
  return place;
}

}  // namespace lumen
