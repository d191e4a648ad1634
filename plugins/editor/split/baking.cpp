#include "baking.h"

#include <algorithm>

namespace {

using namespace lumen;

constexpr const char *splitter_type = "splitter.plane", *filter_type = "filter.split";

/// What the plane's place is made of: the same in both.
constexpr const char* shared[] = {"translation", "axis", "angle", "offset", "whole"};

std::string instance_of(const std::string& path) { return path.substr(0, path.find('.')); }

std::string link_of(const Workbench& workbench, const std::string& path) {
  const auto state = workbench.property(path);
  return state ? state->link : std::string();
}

std::vector<std::string> splitters_of(const Workbench& workbench, const std::string& surface) {
  const auto state = workbench.property(surface + ".splitter");
  const auto* references = state ? std::get_if<References>(&state->value) : nullptr;
  return references ? references->ids : std::vector<std::string>();
}

std::shared_ptr<const Mesh> mesh_at(const Workbench& workbench, const std::string& path) {
  const auto state = workbench.property(path);
  const auto* data = state ? std::get_if<DataPointer>(&state->value) : nullptr;
  return data ? std::dynamic_pointer_cast<const Mesh>(*data) : nullptr;
}

bool is(const std::vector<InstanceState>& all, const std::string& id, const char* type) {
  return std::any_of(all.begin(), all.end(), [&](const InstanceState& state) { return state.id == id && state.type == type; });
}

/// The filter that would cut the surface as the plane does.
std::string filter_for(const Workbench& workbench, const std::vector<InstanceState>& all, const std::string& surface, const std::string& plane) {
  for (const InstanceState& state : all)
    if (state.type == filter_type && link_of(workbench, state.id + ".translation") == plane + ".translation" &&
        link_of(workbench, state.id + ".transform") == surface + ".transform")
      return state.id;
  return {};
}

/// One undo step, or nothing at all.
template <class Change> void as_one_step(Workbench& workbench, Change change) {
  workbench.begin_edit();
  try {
    change();
    workbench.end_edit();
  } catch (...) {
    workbench.cancel_edit();
    throw;
  }
}

void set_splitters(Workbench& workbench, const std::string& surface, std::vector<std::string> splitters) {
  References references;
  references.ids = std::move(splitters);
  workbench.set(surface + ".splitter", references);
}

}  // namespace

std::vector<CutSurface> cut_surfaces(const Workbench& workbench) {
  const std::vector<InstanceState> all = workbench.instances();
  std::vector<CutSurface> found;
  for (const InstanceState& state : all) {
    if (state.kind != Kind::renderer) continue;
    for (const std::string& splitter : splitters_of(workbench, state.id))
      if (is(all, splitter, splitter_type))
        found.push_back({state.id, splitter, filter_for(workbench, all, state.id, splitter), false, mesh_at(workbench, state.id + ".mesh")});
    const std::string filter = instance_of(link_of(workbench, state.id + ".mesh")), plane = instance_of(link_of(workbench, filter + ".translation"));
    if (is(all, filter, filter_type) && is(all, plane, splitter_type)) found.push_back({state.id, plane, filter, true, mesh_at(workbench, filter + ".mesh")});
  }
  return found;
}

void cut_once(Workbench& workbench, const CutSurface& cut) {
  const std::string source = link_of(workbench, cut.surface + ".mesh");
  if (source.empty()) throw Error(cut.surface + ".mesh", "no mesh is linked to it");
  as_one_step(workbench, [&] {
    const std::string filter = cut.filter.empty() ? workbench.add(filter_type) : cut.filter;
    workbench.link(filter + ".mesh", source, {});
    workbench.link(filter + ".transform", cut.surface + ".transform", {});
    for (const char* property : shared) workbench.link(filter + "." + property, cut.plane + "." + property, {});
    const auto look = workbench.property(cut.plane + ".interior");
    workbench.set(filter + ".capped", look && look->value == Value(Choice{"cap"}));
    workbench.set(filter + ".doubled", true);  // for the picture: normals as before the cut
    workbench.set(filter + ".enabled", true);
    std::vector<std::string> splitters = splitters_of(workbench, cut.surface);
    std::erase(splitters, cut.plane);
    set_splitters(workbench, cut.surface, std::move(splitters));
    workbench.link(cut.surface + ".mesh", filter + ".result", {});
  });
}

void cut_each_frame(Workbench& workbench, const CutSurface& cut) {
  const std::string source = link_of(workbench, cut.filter + ".mesh");
  if (source.empty()) throw Error(cut.filter + ".mesh", "no mesh is linked to it");
  as_one_step(workbench, [&] {
    workbench.link(cut.surface + ".mesh", source, {});
    std::vector<std::string> splitters = splitters_of(workbench, cut.surface);
    splitters.push_back(cut.plane);
    set_splitters(workbench, cut.surface, std::move(splitters));
    workbench.set(cut.filter + ".enabled", false);
  });
}

std::size_t bytes_of_halves(const Workbench& workbench, const std::string& filter) {
  std::size_t bytes = 0;
  for (const char* output : {".result", ".half_a", ".half_b"})
    if (const auto mesh = mesh_at(workbench, filter + output)) bytes += mesh->bytes();
  return bytes;
}
