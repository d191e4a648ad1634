#include "plane_cut.h"

#include <algorithm>

#include <lumen/components.h>
#include <lumen/section.h>

namespace {

bool same_mesh(const std::weak_ptr<const lumen::Mesh>& a, const std::weak_ptr<const lumen::Mesh>& b) { return !a.owner_before(b) && !b.owner_before(a); }

}  // namespace

bool PlaneCut::Asked::same(const Asked& other) const {
  return same_mesh(mesh, other.mesh) && object_to_world == other.object_to_world && plane == other.plane && whole == other.whole && capped == other.capped;
}

PlaneCut::PlaneCut(Asked what) : asked(std::move(what)) {
  find_groups();
  find_section();
}

PlaneCut::PlaneCut(Asked what, const PlaneCut& before) : asked(std::move(what)) {
  if (same_mesh(asked.mesh, before.asked.mesh) && asked.whole == before.asked.whole) groups = before.groups;
  else find_groups();
  find_section();
}

void PlaneCut::find_groups() {
  const auto mesh = asked.mesh.lock();
  if (mesh == nullptr || asked.whole.empty()) return;
  std::vector<std::uint32_t> group = lumen::connected_parts(*mesh).of_triangle;
  for (std::uint32_t& number : group) number = std::find(asked.whole.begin(), asked.whole.end(), int(number)) != asked.whole.end() ? 1 : 0;
  groups = std::make_shared<const std::vector<std::uint32_t>>(std::move(group));
}

void PlaneCut::find_section() {
  const auto mesh = asked.mesh.lock();
  if (mesh == nullptr) return;
  const std::span<const std::uint32_t> group = groups == nullptr ? std::span<const std::uint32_t>() : std::span<const std::uint32_t>(*groups);
  const lumen::Section section = lumen::section_of(*mesh, asked.object_to_world, asked.plane, group, groups == nullptr ? -1 : 0);
  closed = section.closed;
  if (!closed) return;
  openings = lumen::spheres_around(section.outlines);
  if (!asked.capped || section.outlines.empty()) return;
  lumen::Filling filling = lumen::fill(section.outlines, glm::vec3(asked.plane));
  auto face = std::make_shared<lumen::Mesh>();
  face->origin = "cap";
  face->positions = std::move(filling.positions);
  face->triangles = std::move(filling.triangles);
  face->finish();
  cap = std::move(face);
}
