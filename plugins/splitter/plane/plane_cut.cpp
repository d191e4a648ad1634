#include "plane_cut.h"

#include <lumen/section.h>

bool PlaneCut::Asked::same(const Asked& other) const {
  return mesh.lock() == other.mesh.lock() && object_to_world == other.object_to_world && plane == other.plane && groups == other.groups && capped == other.capped;
}

PlaneCut::PlaneCut(Asked what) : asked(std::move(what)) {
  const auto mesh = asked.mesh.lock();
  if (mesh == nullptr) return;
  const std::span<const std::uint32_t> group = asked.groups == nullptr ? std::span<const std::uint32_t>() : std::span<const std::uint32_t>(*asked.groups);
  const lumen::Section section = lumen::section_of(*mesh, asked.object_to_world, asked.plane, group, asked.groups == nullptr ? -1 : 0);
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
