#include "ray_scene.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <lumen/mesh.h>

namespace {

bool same(const lumen::TracedSurface& a, const lumen::TracedSurface& b) {
  return a.mesh == b.mesh && a.object_to_world == b.object_to_world && a.split == b.split;
}

/// Triangles moved by `to_world`, cut by planes where they were before the part's move; with `groups`, those of the part's.
void add(lumen::RayTriangles& world, const lumen::Mesh& mesh, const glm::mat4& to_world, const lumen::Part& part, const std::vector<glm::vec4>& planes,
         const std::vector<std::uint32_t>* groups) {
  const auto within = [&](std::size_t triangle) { return groups == nullptr || part.group < 0 || (*groups)[triangle] == std::uint32_t(part.group); };
  std::size_t count = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) count += within(i);
  if (count == 0) return;
  std::function<bool(const glm::vec3&)> removed;
  if (!planes.empty())
    removed = [planes, to_unmoved = glm::inverse(part.transform)](const glm::vec3& hit) {
      const glm::vec4 place = to_unmoved * glm::vec4(hit, 1);
      return std::any_of(planes.begin(), planes.end(), [&](const glm::vec4& plane) { return glm::dot(plane, place) < 0; });
    };
  const lumen::RayTriangles::Room room = world.add(mesh.positions.size(), count, std::move(removed));
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) room.positions[i] = glm::vec3(to_world * glm::vec4(mesh.positions[i], 1));
  auto next = room.triangles.begin();
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    if (within(i)) *next++ = mesh.triangles[i];
}

}  // namespace

RayScene::RayScene(std::vector<lumen::TracedSurface> surfaces) : surfaces_(std::move(surfaces)) {
  for (const lumen::TracedSurface& surface : surfaces_) add_split(surface);
  world_.build();
}

void RayScene::add_split(const lumen::TracedSurface& surface) {
  for (const lumen::Part& part : surface.split.parts)
    add(world_, *surface.mesh, part.transform * surface.object_to_world, part, part.planes, surface.split.groups.get());
  for (const lumen::Cap& cap : surface.split.caps) {
    const lumen::Part& part = surface.split.parts[std::size_t(cap.part)];
    std::vector<glm::vec4> others = part.planes;
    others.erase(others.begin() + cap.plane);
    add(world_, *cap.shape, part.transform, part, others, nullptr);
  }
}

bool RayScene::shows(std::span<const lumen::TracedSurface> surfaces) const {
  return std::equal(surfaces.begin(), surfaces.end(), surfaces_.begin(), surfaces_.end(), same);
}
