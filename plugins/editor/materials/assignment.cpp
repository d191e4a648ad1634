#include "assignment.h"

#include <algorithm>

namespace {

using namespace lumen;

struct Place {
  std::string term;      ///< the surface's property, and the term's kind
  std::string property;  ///< the term's picture
};

Place place_of(Role role) { return role == Role::highlight ? Place{"specular", "highlight"} : Place{"diffuse", name_of(role)}; }

std::string reference_at(const Workbench& workbench, const std::string& path) {
  const auto state = workbench.property(path);
  const auto* reference = state ? std::get_if<Reference>(&state->value) : nullptr;
  return reference ? reference->id : std::string();
}

std::string type_of_instance(const Workbench& workbench, const std::string& id) {
  for (const InstanceState& each : workbench.instances())
    if (each.id == id) return each.type;
  return {};
}

/// Whether something other than this surface refers to the term: another surface must not change with this one.
bool is_shared(const Workbench& workbench, const std::string& term, const std::string& surface) {
  for (const InstanceState& each : workbench.instances()) {
    if (each.id == surface || each.id == term) continue;
    for (const PropertyState& state : workbench.properties(each.id))
      if (const auto* reference = std::get_if<Reference>(&state.value); reference && reference->id == term) return true;
  }
  return false;
}

/// What was set and linked, as a session has it.
std::string settings_of(const Workbench& workbench, const std::string& instance) {
  std::string text;
  for (const PropertyState& state : workbench.properties(instance)) {
    if (state.spec.output || !(state.set || !state.link.empty())) continue;
    std::string value;
    if (state.link.empty()) value = workbench.to_json(state.value);
    else value = "{\"link\": " + workbench.to_json(Value(state.link)) + (state.expression.empty() ? "" : ", \"expression\": " + workbench.to_json(Value(state.expression))) + "}";
    text += (text.empty() ? "\"" : ", \"") + state.spec.id + "\": " + value;
  }
  return "{" + text + "}";
}

/// The surface's own lit-sphere term of this kind; made if it has none, copied if others use it, too.
std::string own_term(Workbench& workbench, const std::string& surface, const std::string& kind, const std::string& settings) {
  const std::string type = kind + ".lit_sphere", path = surface + "." + kind, present = reference_at(workbench, path);
  const bool fits = type_of_instance(workbench, present) == type;
  if (fits && !is_shared(workbench, present, surface)) return present;
  const std::string term = workbench.add(type, fits ? settings_of(workbench, present) : settings);
  workbench.set(path, Reference{term});
  return term;
}

std::string importer_of(Workbench& workbench, const Material& material) {
  for (const InstanceState& each : workbench.instances())
    if (makes(workbench, each.id, material)) return each.id;
  return workbench.add(material.type, material.json());
}

void show(Workbench& workbench, const std::string& term, const std::string& property, const std::string& source, const Material& material) {
  workbench.link(term + "." + property, source + ".image", {});
  const std::string mapping = term + "." + property + "_mapping", wanted = material.equidistant ? "equidistant" : "orthographic";
  const auto state = workbench.property(mapping);
  if (state && !(std::get<Choice>(state->value) == wanted)) workbench.set(mapping, Choice{wanted});
}

}  // namespace

bool takes_materials(const Workbench& workbench, const std::string& instance) {
  const auto diffuse = workbench.property(instance + ".diffuse");
  return diffuse && diffuse->spec.type == ValueType::reference;
}

bool makes(const Workbench& workbench, const std::string& instance, const Material& material) {
  if (type_of_instance(workbench, instance) != material.type) return false;
  for (const PropertyState& state : workbench.properties(instance)) {
    const auto wanted = std::find_if(material.values.begin(), material.values.end(), [&](const auto& value) { return value.first == state.spec.id; });
    if (wanted == material.values.end()) {
      if (state.set || !state.link.empty()) return false;
      continue;
    }
    if (!(workbench.from_json(instance + "." + wanted->first, wanted->second) == state.value)) return false;
  }
  return true;
}

std::string picture_of(const Workbench& workbench, const std::string& surface, Role role) {
  const Place place = place_of(role);
  const std::string term = reference_at(workbench, surface + "." + place.term);
  if (term.empty()) return {};
  const auto picture = workbench.property(term + "." + place.property);
  return picture ? picture->link.substr(0, picture->link.find('.')) : std::string();
}

void assign(Workbench& workbench, const std::string& surface, Role role, const Material& material) {
  if (!takes_materials(workbench, surface)) throw Error(surface.empty() ? "materials" : surface, "is no surface that could take a material", "select a surface");
  workbench.begin_edit();
  try {
    const std::string source = importer_of(workbench, material);
    const Place place = place_of(role);
    const bool first = type_of_instance(workbench, reference_at(workbench, surface + ".diffuse")) != "diffuse.lit_sphere";
    // What was captured or painted is right as it was seen; a term that is there already keeps what the person chose.
    const std::string space = material.seen ? R"("space": "view")" : "";
    const std::string dark = role == Role::highlight ? "" : R"("fill_dark": false)", comma = space.empty() || dark.empty() ? "" : ", ";
    show(workbench, own_term(workbench, surface, place.term, "{" + space + comma + dark + "}"), place.property, source, material);
    const bool ambient_shows_dark = type_of_instance(workbench, reference_at(workbench, surface + ".ambient")) == "ambient.lit_sphere";
    if (role != Role::highlight && (first || ambient_shows_dark))
      workbench.link(own_term(workbench, surface, "ambient", "{" + space + "}") + "." + place.property, source + ".image", {});
    const std::string specular = reference_at(workbench, surface + ".specular");
    if (role != Role::highlight && first && !specular.empty() && type_of_instance(workbench, specular) != "specular.lit_sphere") workbench.set(surface + ".specular", Reference{});
    workbench.end_edit();
  } catch (...) {
    workbench.cancel_edit();
    throw;
  }
}
