/// What the splitters of a scene make of its surfaces: their splits, composed.
#include <algorithm>

#include <lumen/mesh.h>
#include <lumen/renderer.h>
#include <lumen/splitter.h>

#include "frame/split_store.h"
#include "frame/view_scene.h"

namespace lumenshop {
namespace {

using lumen::Kind;

constexpr std::size_t most_parts = 4096, most_planes = 8;

/// The caps of `of`'s part `index`, in `part`, whose planes are the same from `first_plane` on. `grouped`: the part holds fewer triangles than
/// the cap was made for.
void take_caps(lumen::Split& both, lumen::Part& part, const lumen::Split& of, std::size_t index, std::size_t first_plane, bool grouped, const lumen::TracedSurface& surface, SplitStore& store) {
  for (lumen::Cap cap : of.caps) {
    if (cap.part != int(index)) continue;
    cap.part = int(both.parts.size());
    cap.plane += int(first_plane);
    if (grouped && surface.mesh != nullptr) {
      const SplitStore::GroupCap& own = store.cap(cap, part.planes.at(std::size_t(cap.plane)), *surface.mesh, surface.object_to_world, both.groups, part.group);
      if (!own.closed) part.openings.reset();
      if (own.shape == nullptr) continue;
      cap.shape = own.shape;
    }
    both.caps.push_back(std::move(cap));
  }
}

/// Cut by both; what `a` moved is moved further by `b`.
lumen::Split composed(const lumen::Split& a, const lumen::Split& b, const lumen::TracedSurface& traced, const std::string& surface, SplitStore& store) {
  if (a.parts.size() * b.parts.size() > most_parts) throw lumen::Error(surface, "its splitters make more than 4096 parts of it");
  lumen::Split both{.parts = {}};
  const CommonGroups* common = a.groups != nullptr && b.groups != nullptr ? &store.common(a.groups, b.groups) : nullptr;
  both.groups = common != nullptr ? common->groups : a.groups != nullptr ? a.groups : b.groups;
  for (std::size_t i = 0; i < a.parts.size(); ++i)
    for (std::size_t k = 0; k < b.parts.size(); ++k) {
      const lumen::Part &first = a.parts[i], &second = b.parts[k];
      lumen::Part part{.transform = second.transform * first.transform, .planes = first.planes, .removable = first.removable && second.removable};
      part.planes.insert(part.planes.end(), second.planes.begin(), second.planes.end());
      part.group = first.group < 0 ? second.group : first.group;
      if (first.group >= 0 && second.group >= 0 && common != nullptr) {
        const auto pair = common->number.find({first.group, second.group});
        if (pair == common->number.end()) continue;  // no triangle is in both
        part.group = pair->second;
      }
      if (first.openings && second.openings) {
        part.openings = first.openings;
        part.openings->insert(part.openings->end(), second.openings->begin(), second.openings->end());
      }
      take_caps(both, part, a, i, 0, second.group >= 0, traced, store);
      take_caps(both, part, b, k, first.planes.size(), first.group >= 0, traced, store);
      both.parts.push_back(std::move(part));
    }
  if (both.parts.empty()) throw lumen::Error(surface, "its splitters leave nothing of it");
  return both;
}

void check(const lumen::Split& split, const lumen::Mesh* mesh, const std::string& splitter) {
  if (split.parts.empty()) throw lumen::Error(splitter, "it makes no part");
  if (split.groups != nullptr && (mesh == nullptr || split.groups->size() != mesh->triangles.size())) throw lumen::Error(splitter, "its groups are not those of the surface's triangles");
  for (const lumen::Part& part : split.parts)
    if (part.planes.size() > most_planes) throw lumen::Error(splitter, "a part has more than 8 planes");
  for (const lumen::Cap& cap : split.caps)
    if (cap.shape == nullptr || cap.part < 0 || std::size_t(cap.part) >= split.parts.size() || cap.plane < 0 ||
        std::size_t(cap.plane) >= split.parts[std::size_t(cap.part)].planes.size())
      throw lumen::Error(splitter, "a cap has no part, plane or shape");
}

lumen::Split split_of(const SceneSurface& surface, const lumen::Camera& camera, SplitStore& store) {
  const auto* renderer = surface.instance->as<lumen::Renderer>(Kind::renderer);
  const lumen::TracedSurface traced = renderer->traced();
  lumen::Split split;
  for (std::size_t i = 0; i < surface.splitters.size(); ++i) {
    Instance& splitter = *surface.splitters[i];
    auto* plugin = splitter.as<lumen::Splitter>(Kind::splitter);
    lumen::Split own = plugin->split({.mesh = traced.mesh, .object_to_world = traced.object_to_world, .bounds = renderer->bounds(), .camera = camera});
    check(own, traced.mesh.get(), splitter.id());
    split = i == 0 ? std::move(own) : composed(split, own, traced, surface.instance->id(), store);
  }
  check(split, traced.mesh.get(), surface.instance->id());
  return split;
}

}  // namespace

bool SceneSurface::removes() const {
  return std::any_of(splitters.begin(), splitters.end(), [](Instance* splitter) { return splitter->as<lumen::Splitter>(Kind::splitter)->removes(); });
}

void split_surfaces(ViewScene& scene, const lumen::Camera& camera, SplitStore& store) {
  for (auto* surfaces : {&scene.opaque, &scene.transparent})
    for (SceneSurface& surface : *surfaces)
      for (Instance* splitter : surface.splitters) splitter->clear_reports();
  for (auto* surfaces : {&scene.opaque, &scene.transparent})
    for (SceneSurface& surface : *surfaces) {
      try {
        surface.split = split_of(surface, camera, store);
      } catch (const std::exception& error) {
        scene.problems.push_back({.severity = lumen::Severity::error, .instance = surface.splitters.front()->id(), .message = error.what()});
        surface.splitters.clear();
        surface.interior = nullptr;
      }
      const lumen::Bounds bounds = surface.instance->as<lumen::Renderer>(Kind::renderer)->bounds();
      for (const lumen::Part& part : surface.split.parts) scene.split_bounds.include(bounds.transformed(part.transform));
    }
  store.forget_unused();
}

}  // namespace lumenshop
