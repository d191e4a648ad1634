#include "inward_parts.h"

#include <algorithm>
#include <numeric>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace {

/// A number that no other edge is likely to have.
std::uint64_t number_of(std::uint64_t low, std::uint64_t high) {
  std::uint64_t x = (low << 32 | high) * 0xd6e8feb86659fd93ull + 0x9e3779b97f4a7c15ull;
  x = (x ^ x >> 32) * 0xd6e8feb86659fd93ull;
  return x ^ x >> 29;
}

/// The connected parts of a surface, each known by one of its points.
class Parts {
 public:
  explicit Parts(const WeldedSurface& surface) : surface_(surface), part_(surface.positions.size()), volume_(part_.size(), 0.0), open_(part_.size(), 0) {
    std::iota(part_.begin(), part_.end(), 0u);
    for (const glm::uvec3& t : surface.triangles) {
      part_[root(t.y)] = root(t.x);
      part_[root(t.z)] = root(t.x);
    }
    for (std::uint32_t point = 0; point < part_.size(); ++point) part_[point] = root(point);
    for (const glm::uvec3& t : surface.triangles) {
      const std::uint32_t part = part_[t.x];
      volume_[part] += glm::dot(surface.positions[t.x], glm::cross(surface.positions[t.y], surface.positions[t.z]));
      for (int corner = 0; corner < 3; ++corner) {
        const std::uint32_t from = t[corner], to = t[(corner + 1) % 3];
        if (from < to) open_[part] += number_of(from, to);
        else if (to < from) open_[part] -= number_of(to, from);
      }
    }
  }

  std::uint32_t part_of(std::uint32_t point) const { return part_[point]; }
  bool is_inside_out(std::uint32_t part) const { return part_[part] == part && open_[part] == 0 && volume_[part] < 0 && !is_enclosed(part); }

 private:
  std::uint32_t root(std::uint32_t point) {
    while (part_[point] != point) point = part_[point] = part_[part_[point]];
    return point;
  }

  /// Whether a line from one of its points leaves other parts and enters them unequally often. It goes askew: straight ones meet the
  /// edges of regular meshes.
  bool is_enclosed(std::uint32_t part) const {
    const glm::dvec3& from = surface_.positions[part];
    const glm::dvec3 up = glm::normalize(glm::dvec3(0.3713, 0.5891, 0.7179)), right = glm::normalize(glm::cross(up, glm::dvec3(0.1327, 0.8311, -0.3373)));
    const glm::dmat3 askew = glm::transpose(glm::dmat3(right, glm::cross(up, right), up));
    int leaves = 0;
    for (const glm::uvec3& t : surface_.triangles) {
      if (part_[t.x] == part) continue;
      glm::dvec3 corners[3];
      for (int corner = 0; corner < 3; ++corner) corners[corner] = askew * (surface_.positions[t[corner]] - from);
      if (std::max({corners[0].z, corners[1].z, corners[2].z}) < 0) continue;
      int lefts = 0;
      for (int corner = 0; corner < 3; ++corner) {
        const glm::dvec3 &a = corners[corner], &b = corners[(corner + 1) % 3];
        lefts += a.x * b.y > a.y * b.x;
      }
      if (lefts != 0 && lefts != 3) continue;
      const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
      if (normal.z != 0 && glm::dot(corners[0], normal) * normal.z > 0) leaves += normal.z > 0 ? 1 : -1;
    }
    return leaves != 0;
  }

  const WeldedSurface& surface_;
  std::vector<std::uint32_t> part_;     ///< by point
  std::vector<double> volume_;          ///< by part: six times
  std::vector<std::uint64_t> open_;     ///< by part: the edges' numbers, which cancel where each is used as often either way
};

}  // namespace

std::vector<bool> inward_points(const WeldedSurface& surface, const std::function<void(float)>& progress) {
  progress(0);
  const Parts parts(surface);
  std::vector<bool> inward(surface.positions.size());
  for (std::uint32_t part = 0; part < inward.size(); ++part)
    if (parts.is_inside_out(part)) {
      progress(float(part) / float(inward.size()));
      inward[part] = true;
    }
  for (std::uint32_t point = 0; point < inward.size(); ++point) inward[point] = inward[parts.part_of(point)];
  return inward;
}
