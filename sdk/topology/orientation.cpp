#include <topology/orientation.h>

#include <algorithm>
#include <numeric>
#include <optional>

#include <topology/neighbors.h>

namespace lumen {

namespace {

std::uint64_t scrambled(std::uint64_t x) {  // splitmix64, Steele et al. 2014
  x += 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

/// A random number of the edge, signed by its direction; 0 if it has no length. Without branches: directions cannot be guessed.
std::uint64_t signed_number(std::uint64_t a, std::uint64_t b) {
  const std::uint64_t direction = std::uint64_t(a < b) - std::uint64_t(b < a);
  return scrambled(std::min(a, b) << 32 | std::max(a, b)) * direction;
}

/// The corners of a triangle by the numbers of their points, turned around if so marked.
class Triangles {
 public:
  Triangles(const Mesh& mesh, std::vector<std::uint32_t> points) : mesh_(mesh), points_(std::move(points)) {}

  std::size_t count() const { return mesh_.triangles.size(); }
  glm::uvec3 operator[](std::size_t i) const {
    const glm::uvec3& t = mesh_.triangles[i];
    const glm::uvec3 corners = points_.empty() ? t : glm::uvec3(points_[t.x], points_[t.y], points_[t.z]);
    return !turned.empty() && turned[i] ? glm::uvec3(corners.x, corners.z, corners.y) : corners;
  }
  const Mesh& mesh() const { return mesh_; }

  std::vector<bool> turned;

 private:
  const Mesh& mesh_;
  std::vector<std::uint32_t> points_;  ///< the number of each position; empty: its own
};

/// What a surface encloses, part by connected part.
class Enclosure {
 public:
  explicit Enclosure(const Triangles& triangles) : triangles_(triangles), part_(triangles.mesh().positions.size()), volume_(part_.size(), 0.0) {
    std::iota(part_.begin(), part_.end(), 0u);
    const auto& positions = triangles.mesh().positions;
    const glm::dvec3 origin(triangles.mesh().bounds().center());
    for (std::size_t i = 0; i < triangles.count(); ++i) {
      const glm::uvec3 t = triangles[i];
      const std::uint64_t numbers[] = {signed_number(t.x, t.y), signed_number(t.y, t.z), signed_number(t.z, t.x)};
      for (const std::uint64_t number : numbers) {
        directed_ += number;
        undirected_ ^= std::min(number, 0 - number);
      }
      const std::uint32_t part = root(t.x);
      if (part_[t.y] != part) part_[root(t.y)] = part;
      if (part_[t.z] != part) part_[root(t.z)] = part;
      volume_[part] += glm::dot(glm::dvec3(positions[t.x]) - origin, glm::cross(glm::dvec3(positions[t.y]) - origin, glm::dvec3(positions[t.z]) - origin));
    }
    for (std::uint32_t i = 0; i < part_.size(); ++i)  // parts grew together after something was added to them
      if (const std::uint32_t part = root(i); part != i) {
        volume_[part] += volume_[i];
        part_[i] = part;
      }
  }

  /// Every edge is used as often in one direction as in the other: their numbers cancel.
  bool closed() const { return directed_ == 0; }
  /// Every edge is used an even number of times.
  bool even() const { return undirected_ == 0; }

  /// The parts that face inward although nothing encloses them, turned around; those that are enclosed are cavities.
  std::vector<bool> turned_outward() const {
    std::vector<bool> turned = triangles_.turned;
    for (std::uint32_t part = 0; part < part_.size(); ++part) {
      if (part_[part] != part || volume_[part] >= 0 || enclosed(part)) continue;
      turned.resize(triangles_.count());
      for (std::size_t i = 0; i < turned.size(); ++i)
        if (part_[triangles_[i].x] == part) turned[i] = !turned[i];
    }
    return turned;
  }

 private:
  std::uint32_t root(std::uint32_t i) {
    while (part_[i] != i) i = part_[i] = part_[part_[i]];
    return i;
  }

  /// Other parts wind around a point of this one: a line upward from it leaves them more often than it enters, or less.
  bool enclosed(std::uint32_t part) const {
    const auto& positions = triangles_.mesh().positions;
    const glm::dvec3 from(positions[part]);
    int winding = 0;
    for (std::size_t i = 0; i < triangles_.count(); ++i) {
      const glm::uvec3 t = triangles_[i];
      if (part_[t.x] == part) continue;
      const glm::dvec3 a = glm::dvec3(positions[t.x]) - from, b = glm::dvec3(positions[t.y]) - from, c = glm::dvec3(positions[t.z]) - from;
      // A line that meets an edge passes it on the side of a point beside it: on the same for both its triangles.
      const auto left = [](const glm::dvec3& p, const glm::dvec3& q) {
        const double turn = p.x * q.y - p.y * q.x;
        return turn != 0 ? turn > 0 : p.y != q.y ? p.y > q.y : p.x < q.x;
      };
      const bool side = left(a, b);
      if (side != left(b, c) || side != left(c, a)) continue;
      const glm::dvec3 normal = glm::cross(b - a, c - a);
      if (normal.z != 0 && glm::dot(a, normal) / normal.z > 0) winding += normal.z > 0 ? 1 : -1;
    }
    return winding != 0;
  }

  const Triangles& triangles_;
  std::uint64_t directed_ = 0, undirected_ = 0;
  std::vector<std::uint32_t> part_;  ///< by point; a forest, at last one step deep: the root of a tree stands for the part
  std::vector<double> volume_;       ///< six times, of what was added to a part while this was its root
};

/// Which triangles to turn so that neighbors across an edge of two agree. Where they cannot, no matter.
std::vector<bool> turned_alike(const Triangles& triangles) {
  const Neighbors neighbors(triangles.count(), [&](std::size_t i) { return triangles[i]; });
  std::vector<bool> turned(triangles.count()), seen(triangles.count());
  std::vector<std::uint32_t> open;
  for (std::uint32_t first = 0; first < triangles.count(); ++first) {
    if (seen[first]) continue;
    seen[first] = true;
    open.push_back(first);
    while (!open.empty()) {
      const std::uint32_t triangle = open.back();
      open.pop_back();
      for (const Neighbor& neighbor : neighbors[triangle]) {
        if (neighbor.triangle == Neighbor::none || seen[neighbor.triangle]) continue;
        seen[neighbor.triangle] = true;
        turned[neighbor.triangle] = turned[triangle] != neighbor.disagrees;
        open.push_back(neighbor.triangle);
      }
    }
  }
  return turned;
}

/// Nothing if the surface is open.
std::optional<Orientation> closed_orientation(Triangles triangles) {
  Enclosure enclosure(triangles);
  if (!enclosure.even()) return std::nullopt;
  if (enclosure.closed()) return Orientation{.solid = true, .turned = enclosure.turned_outward()};
  triangles.turned = turned_alike(triangles);
  Enclosure alike(triangles);
  if (!alike.closed()) return std::nullopt;
  return Orientation{.solid = true, .turned = alike.turned_outward()};
}

}  // namespace

Orientation orientation_of(const Mesh& mesh) {
  // Points are merged only where the mesh is open without it: that takes longer than all the rest.
  if (auto found = closed_orientation(Triangles(mesh, {}))) return *std::move(found);
  if (auto found = closed_orientation(Triangles(mesh, merged_points(mesh)))) return *std::move(found);
  return {};
}

}  // namespace lumen
