/// Lines filled by the tessellator and stitched to their points by number. A filling counts only if it uses every edge of the lines
/// once, and each of its other edges once each way.
#include "caps.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <unordered_map>

#include <glm/geometric.hpp>
#include <lumen/components.h>
#include <lumen/error.h>
#include <lumen/section.h>

namespace {

constexpr std::uint32_t none = 0xffffffffu;

std::uint64_t directed(std::uint32_t a, std::uint32_t b) { return std::uint64_t(a) << 32 | b; }

using Place = std::function<glm::vec2(std::uint32_t)>;
using Lines = std::vector<const Loop*>;

/// The faces between some lines.
class Faces {
 public:
  Faces(const Lines& lines, const Place& place) : lines_(lines), place_(place) {}

  /// False if they cannot be closed: then nothing of it is of use.
  bool fill() {
    if (!tessellate()) return false;
    for (const Loop* line : lines_)
      for (std::size_t i = 0; i < line->points.size(); ++i) border_.emplace(directed(line->points[i], line->points[(i + 1) % line->points.size()]), line->triangle);
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
      for (int corner = 0; corner < 3; ++corner)
        if (!owner_.emplace(edge(i, corner), i).second) return false;
    spread();
    return find_faces();
  }

  std::vector<glm::uvec3> triangles;
  std::vector<std::uint32_t> faces, beside;

 private:
  std::uint64_t edge(std::uint32_t triangle, int corner) const { return directed(triangles[triangle][corner], triangles[triangle][(corner + 1) % 3]); }
  bool is_border(std::uint64_t edge) const { return border_.contains(edge) || border_.contains(edge << 32 | edge >> 32); }

  bool tessellate() {
    lumen::Outlines outlines;
    std::vector<std::uint32_t> numbers;
    std::map<std::array<float, 2>, std::uint32_t> at;
    for (const Loop* line : lines_) {
      auto& outline = outlines.emplace_back();
      for (const std::uint32_t point : line->points) {
        const glm::vec2 place = place_(point);
        outline.emplace_back(place, 0);
        numbers.push_back(point);
        at.emplace(std::array{place.x, place.y}, point);
      }
    }
    try {
      const lumen::Filling filling = lumen::fill(outlines, {0, 0, 1});
      // A line that touches itself or another in a point has that point once more; any other new point is where lines cross.
      for (std::size_t i = numbers.size(); i < filling.positions.size(); ++i) {
        const auto found = at.find({filling.positions[i].x, filling.positions[i].y});
        if (found == at.end()) return false;
        numbers.push_back(found->second);
      }
      for (const glm::uvec3& t : filling.triangles) {
        triangles.emplace_back(numbers[t.x], numbers[t.y], numbers[t.z]);
        if (numbers[t.x] == numbers[t.y] || numbers[t.y] == numbers[t.z] || numbers[t.z] == numbers[t.x]) return false;
      }
    } catch (const lumen::Error&) {
      return false;
    }
    return true;
  }

  bool is_flat(const glm::uvec3& t) const {
    constexpr double least = 1e-6;  // of the longest side
    const glm::dvec2 a(place_(t.x)), b(place_(t.y)), c(place_(t.z));
    const double longest = std::max({glm::dot(b - a, b - a), glm::dot(c - b, c - b), glm::dot(a - c, a - c)});
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) <= least * longest;
  }

  /// Points in a row give triangles without area, which the edge opposite of their middle point is turned away from.
  void spread() {
    constexpr int most_rounds = 32;
    bool changed = true;
    for (int round = 0; round < most_rounds && changed; ++round) {
      changed = false;
      for (std::uint32_t i = 0; i < triangles.size(); ++i)
        if (is_flat(triangles[i])) changed = turn_longest(i) || changed;
    }
  }

  bool turn_longest(std::uint32_t triangle) {
    const glm::uvec3 t = triangles[triangle];
    int corner = 0;
    double longest = -1;
    for (int i = 0; i < 3; ++i) {
      const double length = glm::distance(glm::dvec2(place_(t[i])), glm::dvec2(place_(t[(i + 1) % 3])));
      if (length > longest) longest = length, corner = i;
    }
    const std::uint32_t a = t[corner], b = t[(corner + 1) % 3], c = t[(corner + 2) % 3];
    const auto beyond = owner_.find(directed(b, a));
    if (is_border(directed(a, b)) || beyond == owner_.end()) return false;
    const std::uint32_t other = beyond->second;
    const glm::uvec3 o = triangles[other];
    const std::uint32_t d = o.x != a && o.x != b ? o.x : o.y != a && o.y != b ? o.y : o.z;
    if (owner_.contains(directed(c, d)) || owner_.contains(directed(d, c)) || is_border(directed(c, d))) return false;
    owner_.erase(directed(a, b));
    owner_.erase(directed(b, a));
    set(triangle, {a, d, c});
    set(other, {d, b, c});
    return true;
  }
  void set(std::uint32_t triangle, const glm::uvec3& corners) {
    triangles[triangle] = corners;
    for (int corner = 0; corner < 3; ++corner) owner_[edge(triangle, corner)] = triangle;
  }

  /// Numbers the connected faces, and turns those whose lines run the other way: of what is turned inside out.
  bool find_faces() {
    faces.assign(triangles.size(), none);
    std::size_t closed = 0;
    for (std::uint32_t first = 0; first < triangles.size(); ++first) {
      if (faces[first] != none) continue;
      std::vector<std::uint32_t> face{first};
      const auto number = std::uint32_t(beside.size());
      faces[first] = number;
      std::size_t along = 0, against = 0;
      std::uint32_t adjoined = none;
      for (std::size_t next = 0; next < face.size(); ++next)
        for (int corner = 0; corner < 3; ++corner) {
          const std::uint64_t here = edge(face[next], corner), back = here << 32 | here >> 32;
          if (const auto found = border_.find(here); found != border_.end()) ++along, adjoined = std::min(adjoined, found->second);
          else if (const auto reverse = border_.find(back); reverse != border_.end()) ++against, adjoined = std::min(adjoined, reverse->second);
          else if (const auto beyond = owner_.find(back); beyond == owner_.end()) return false;
          else if (faces[beyond->second] == none) faces[beyond->second] = number, face.push_back(beyond->second);
        }
      if (along > 0 && against > 0) return false;
      if (against > 0)
        for (const std::uint32_t triangle : face) std::swap(triangles[triangle].y, triangles[triangle].z);
      beside.push_back(adjoined);
      closed += along + against;
    }
    return closed == border_.size();
  }

  const Lines& lines_;
  const Place& place_;
  std::unordered_map<std::uint64_t, std::uint32_t> border_;  ///< directed edge of a line -> a triangle beside the line
  std::unordered_map<std::uint64_t, std::uint32_t> owner_;   ///< directed edge -> its triangle
};

/// The connected part of each triangle of the cut.
std::vector<std::uint32_t> parts_of(const Cut& cut) {
  std::uint32_t points = 0;
  for (const glm::uvec3& t : cut.triangles) points = std::max({points, t.x + 1, t.y + 1, t.z + 1});
  lumen::Mesh connections;  // where the points are does not matter
  connections.positions = std::vector<glm::vec3>(points);
  connections.triangles = cut.triangles;
  return lumen::connected_parts(connections).of_triangle;
}

}  // namespace

Caps caps_of(const Cut& cut, const Place& place) {
  Caps caps;
  const auto add = [&](const Lines& lines) {
    Faces made(lines, place);
    if (!made.fill()) return false;
    for (const std::uint32_t face : made.faces) caps.faces.push_back(face + std::uint32_t(caps.beside.size()));
    caps.triangles.insert(caps.triangles.end(), made.triangles.begin(), made.triangles.end());
    caps.beside.insert(caps.beside.end(), made.beside.begin(), made.beside.end());
    return true;
  };
  Lines all;
  for (const Loop& loop : cut.loops) all.push_back(&loop);
  if (all.empty() || add(all)) return caps;
  const std::vector<std::uint32_t> part = parts_of(cut);
  std::map<std::uint32_t, Lines> parts;
  for (const Loop& loop : cut.loops) parts[part[loop.triangle]].push_back(&loop);
  for (const auto& [number, lines] : parts)
    if (!add(lines)) caps.left_open += lines.size();
  return caps;
}
