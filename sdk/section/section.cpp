/// The outlines of a section: each crossing triangle gives one line, and lines that share an edge of the mesh are joined. Points
/// on the plane count as on its positive side, so that no triangle gives two lines or a point.
#include <lumen/section.h>

#include <algorithm>
#include <string>
#include <unordered_map>

namespace lumen {
namespace {

/// An edge of the mesh, either way around.
std::uint64_t edge_of(std::uint32_t a, std::uint32_t b) { return std::uint64_t(std::min(a, b)) << 32 | std::max(a, b); }

struct Line {
  std::uint64_t from, to;  ///< edges that it runs between
  bool used = false;
};

/// One point for each place: seams of duplicated points do not tear the surface apart.
class Places {
 public:
  explicit Places(const Mesh& mesh) : mesh_(mesh) {}
  std::uint32_t first_at(std::uint32_t point) {
    const glm::vec3 place = mesh_.positions[point] + 0.0f;  // -0 is 0
    return first_.try_emplace(std::string(reinterpret_cast<const char*>(&place), sizeof place), point).first->second;
  }

 private:
  const Mesh& mesh_;
  std::unordered_map<std::string, std::uint32_t> first_;
};

/// The lines of all crossing triangles, directed so that the solid of an outward mesh is on their left about the plane's normal.
std::vector<Line> lines_of(const Mesh& mesh, const std::vector<bool>& positive, std::span<const std::uint32_t> groups, int group) {
  std::vector<Line> lines;
  Places places(mesh);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (group >= 0 && groups[i] != std::uint32_t(group)) continue;
    const glm::uvec3& t = mesh.triangles[i];
    const bool side[] = {positive[t.x], positive[t.y], positive[t.z]};
    if (side[0] == side[1] && side[1] == side[2]) continue;
    const int odd = side[1] == side[2] ? 0 : side[0] == side[2] ? 1 : 2;  // the corner that is alone on its side
    const std::uint32_t alone = places.first_at(t[odd]), next = places.first_at(t[(odd + 1) % 3]), last = places.first_at(t[(odd + 2) % 3]);
    std::uint64_t from = edge_of(alone, last), to = edge_of(alone, next);
    if (!side[odd]) std::swap(from, to);
    lines.push_back({from, to});
  }
  return lines;
}

}  // namespace

Section section_of(const Mesh& mesh, const glm::mat4& object_to_world, const glm::vec4& plane, std::span<const std::uint32_t> groups, int group) {
  const glm::vec4 local = glm::transpose(object_to_world) * plane;
  std::vector<bool> positive(mesh.positions.size());
  for (std::size_t i = 0; i < positive.size(); ++i) positive[i] = glm::dot(glm::vec3(local), mesh.positions[i]) + local.w >= 0;
  std::vector<Line> lines = lines_of(mesh, positive, groups, group);

  const auto point_on = [&](std::uint64_t edge) {
    const glm::vec3 &a = mesh.positions[edge >> 32], &b = mesh.positions[edge & 0xffffffffu];
    const double at_a = glm::dot(glm::dvec3(local), glm::dvec3(a)) + double(local.w), at_b = glm::dot(glm::dvec3(local), glm::dvec3(b)) + double(local.w);
    const double share = at_a == at_b ? 0 : std::clamp(at_a / (at_a - at_b), 0.0, 1.0);
    return glm::vec3(object_to_world * glm::vec4(glm::mix(a, b, share), 1));
  };

  std::unordered_multimap<std::uint64_t, std::size_t> touching;
  touching.reserve(2 * lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    touching.emplace(lines[i].from, i);
    touching.emplace(lines[i].to, i);
  }
  const auto next_at = [&](std::uint64_t edge) -> Line* {
    for (auto [at, end] = touching.equal_range(edge); at != end; ++at)
      if (!lines[at->second].used) return &lines[at->second];
    return nullptr;
  };

  Section section;
  for (Line& first : lines) {
    if (first.used) continue;
    std::vector<glm::vec3> outline;
    // Triangles may be turned inside out: the outline runs as most of its lines do.
    long forward = 0;
    std::uint64_t at = first.from;
    for (Line* line = &first; line != nullptr; line = at == first.from ? nullptr : next_at(at)) {
      line->used = true;
      outline.push_back(point_on(at));
      forward += line->from == at ? 1 : -1;
      at = line->from == at ? line->to : line->from;
    }
    if (at != first.from) {
      section.closed = false;
    } else if (outline.size() >= 3) {
      if (forward < 0) std::reverse(outline.begin(), outline.end());
      section.outlines.push_back(std::move(outline));
    }
  }
  // A matrix that mirrors turns every outline around.
  if (glm::determinant(glm::mat3(object_to_world)) < 0)
    for (auto& outline : section.outlines) std::reverse(outline.begin(), outline.end());
  return section;
}

std::vector<glm::vec4> spheres_around(const Outlines& outlines, std::size_t most) {
  std::vector<glm::vec4> spheres;
  // Beyond the limit, neighbors in the order in which they were found share a sphere.
  const std::size_t together = outlines.size() / std::max<std::size_t>(most, 1) + 1;
  for (std::size_t first = 0; first < outlines.size(); first += together) {
    Bounds box;
    const std::size_t end = std::min(first + together, outlines.size());
    for (std::size_t i = first; i < end; ++i)
      for (const glm::vec3& point : outlines[i]) box.include(point);
    spheres.emplace_back(box.center(), box.radius());
  }
  return spheres;
}

}  // namespace lumen
