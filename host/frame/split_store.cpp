#include "frame/split_store.h"

#include <lumen/section.h>

namespace lumenshop {

const CommonGroups& SplitStore::common(const TriangleGroups& a, const TriangleGroups& b) {
  const auto [found, is_new] = pairs_.try_emplace({a.get(), b.get()});
  Pair& pair = found->second;
  pair.used = true;
  if (!is_new) return pair.common;
  pair.a = a;
  pair.b = b;
  auto both = std::make_shared<std::vector<std::uint32_t>>(a->size());
  for (std::size_t i = 0; i < both->size(); ++i) {
    const std::pair<int, int> groups{int((*a)[i]), int((*b)[i])};
    (*both)[i] = std::uint32_t(pair.common.number.try_emplace(groups, int(pair.common.number.size())).first->second);
  }
  pair.common.groups = std::move(both);
  return pair.common;
}

const SplitStore::GroupCap& SplitStore::cap(const lumen::Cap& cap, const glm::vec4& plane, const lumen::Mesh& mesh, const glm::mat4& object_to_world, const TriangleGroups& groups, int group) {
  const auto [found, is_new] = caps_.try_emplace({cap.shape.get(), groups.get(), group});
  Made& made = found->second;
  made.used = true;
  if (!is_new) return made.cap;
  made.whole = cap.shape;
  made.groups = groups;
  const lumen::Section section = lumen::section_of(mesh, object_to_world, plane, *groups, group);
  made.cap.closed = section.closed;
  if (!section.closed || section.outlines.empty()) return made.cap;
  lumen::Filling filling = lumen::fill(section.outlines, glm::vec3(plane));
  auto face = std::make_shared<lumen::Mesh>();
  face->origin = cap.shape->origin;
  face->positions = std::move(filling.positions);
  face->triangles = std::move(filling.triangles);
  face->finish();
  made.cap.shape = std::move(face);
  return made.cap;
}

void SplitStore::forget_unused() {
  const auto forget = [](auto& map) {
    for (auto entry = map.begin(); entry != map.end();) entry = std::exchange(entry->second.used, false) ? std::next(entry) : map.erase(entry);
  };
  forget(pairs_);
  forget(caps_);
}

}  // namespace lumenshop
