#include "frame/shading.h"

#include <algorithm>
#include <span>

#include "frame/hash.h"

namespace lumenshop {
namespace {

/// A row of lumen_styles in shaders/host/styles.glsl (std430).
struct StyleRow {
  glm::ivec4 rows{0}, variant{0};
  glm::vec4 ambient_color{0.2f, 0.2f, 0.2f, 1}, diffuse_color{0.8f, 0.8f, 0.8f, 1}, specular_color{0, 0, 0, 1};
  glm::vec4 unused[11] = {};
};
static_assert(sizeof(StyleRow) == 256, "bound on its own as a uniform block");

template <class T>
const T* value_of(const Instance& instance, std::string_view property) {
  const int slot = instance.slot_of(property);
  return slot < 0 ? nullptr : std::get_if<T>(&instance.read(slot));
}

std::string file_of(const Instance& instance) {
  std::string file = instance.type();
  std::replace(file.begin(), file.end(), '.', '/');
  return file + ".glsl";
}


/// Its terms from the references `prefix`ambient ... of `owner`; those that are not given stay as they are.
void take_terms(const Session& session, const Instance& owner, const std::string& prefix, SurfaceStyle& style) {
  for (std::size_t i = 0; i < SurfaceStyle::kinds.size(); ++i) {
    const auto* reference = value_of<lumen::Reference>(owner, prefix + std::string(lumen::name_of(SurfaceStyle::kinds[i])));
    if (reference == nullptr || reference->empty()) continue;
    Instance* term = session.find(reference->id);
    if (term != nullptr && term->plugin() != nullptr && term->kind() == SurfaceStyle::kinds[i] && term->enabled()) style.terms[i] = term;
  }
}

void take_material(const Instance& owner, StyleRow& row) {
  if (const auto* color = value_of<lumen::Color>(owner, "ambient_color")) row.ambient_color = glm::vec4(color->rgb, 1);
  if (const auto* color = value_of<lumen::Color>(owner, "diffuse_color")) row.diffuse_color = glm::vec4(color->rgb, 1);
  if (const auto* color = value_of<lumen::Color>(owner, "specular_color")) row.specular_color = glm::vec4(color->rgb, 1);
  if (const auto* shininess = value_of<float>(owner, "shininess")) row.specular_color.w = *shininess;
}

/// See lumen::Interior.
void take_interior_material(const Instance& splitter, StyleRow& row) {
  if (const auto* color = value_of<lumen::Color>(splitter, "interior_color")) row.ambient_color = row.diffuse_color = glm::vec4(color->rgb, 1);
  if (const auto* color = value_of<lumen::Color>(splitter, "interior_specular_color")) row.specular_color = glm::vec4(color->rgb, 1);
  if (const auto* shininess = value_of<float>(splitter, "interior_shininess")) row.specular_color.w = *shininess;
}

SurfaceStyle interior_style_of(const Session& session, const Instance& splitter, SurfaceStyle outside) {
  const auto* look = value_of<lumen::Choice>(splitter, "interior");
  SurfaceStyle style = look != nullptr && *look == "flat" ? SurfaceStyle{} : outside;
  if (look == nullptr || !(*look == "flat")) take_terms(session, splitter, "interior_", style);
  style.terms[3] = outside.terms[3];
  return style;
}

}  // namespace

SurfaceStyle style_of(const Session& session, const Instance& renderer) {
  SurfaceStyle style;
  take_terms(session, renderer, "", style);
  return style;
}

int Shading::term_index(const Instance& instance) {
  const std::string file = file_of(instance), properties = properties_text(instance, "", row_binding::any);
  for (std::size_t i = 0; i < terms_.size(); ++i)
    if (terms_[i].file == file && terms_[i].properties == properties) {
      terms_[i].shared = terms_[i].shared || terms_[i].instance != &instance;
      return int(i);
    }
  const auto versions = std::count_if(terms_.begin(), terms_.end(), [&](const Term& term) { return term.file == file; });
  terms_.push_back({&instance, file, properties, prefix_of(file) + (versions ? "v" + std::to_string(versions) + "_" : "")});
  return int(terms_.size()) - 1;
}

int Shading::variant_index(const SurfaceStyle& style) {
  Variant variant;
  for (std::size_t i = 0; i < style.terms.size(); ++i) variant.terms[i] = style.terms[i] == nullptr ? -1 : term_index(*style.terms[i]);
  auto found = std::find(variants_.begin(), variants_.end(), variant);
  if (found == variants_.end()) found = variants_.insert(variants_.end(), variant);
  return int(found - variants_.begin());
}

void Shading::update(const Session& session, const std::vector<LitSurface>& surfaces, const ValueTable& values) {
  terms_.clear();
  variants_.clear();
  styles_.clear();
  variant_of_.clear();
  interiors_.clear();
  Hash all, opaque;
  const auto add = [&](const LitSurface& surface, const Hash& hash) {
    all.add(hash.value());
    if (!surface.transparent) opaque.add(hash.value());
  };
  std::vector<StyleRow> rows(1);
  const auto row_of = [&](const SurfaceStyle& style, const Instance& renderer, int variant, Hash& hash) {
    StyleRow row;
    for (std::size_t i = 0; i < style.terms.size(); ++i) {
      const Instance* term = style.terms[i];
      row.rows[int(i)] = term == nullptr ? 0 : values.row_of(*term);
      if (term != nullptr) hash.add(term->number()).add(term->draw_revision()).add(term->shading_revision());
    }
    row.variant = {variant, renderer.number(), 0, 0};
    return row;
  };
  for (const LitSurface& surface : surfaces) {
    const Instance& renderer = *surface.renderer;
    const SurfaceStyle style = styles_[&renderer] = style_of(session, renderer);
    Hash hash;
    StyleRow row = row_of(style, renderer, variant_of_[&renderer] = variant_index(style), hash);
    take_material(renderer, row);
    const auto number = std::size_t(renderer.number());
    if (rows.size() <= number) rows.resize(number + 1);
    rows[number] = row;
    add(surface, hash.add(number).add(renderer.shading_revision()));
  }
  // The insides follow after all instances.
  for (const LitSurface& surface : surfaces) {
    if (surface.interior == nullptr) continue;
    const Instance &renderer = *surface.renderer, &splitter = *surface.interior;
    const SurfaceStyle style = interior_style_of(session, splitter, styles_.at(&renderer));
    const int variant = variant_index(style);
    Hash hash;
    StyleRow row = row_of(style, renderer, variant, hash);
    take_interior_material(splitter, row);
    interiors_[&renderer] = {int(rows.size()), variant};
    rows.push_back(row);
    add(surface, hash.add(splitter.number()).add(splitter.draw_revision()).add(splitter.shading_revision()));
  }
  value_revision_ = all.value();
  opaque_revision_ = opaque.value();
  table_.write(std::as_bytes(std::span(rows)));
}

int Shading::interior_row(const Instance& renderer) const {
  const auto found = interiors_.find(&renderer);
  return found == interiors_.end() ? 0 : found->second.row;
}

int Shading::binding_of(int term) const {
  return terms_[std::size_t(term)].shared || term >= row_binding::term_count ? row_binding::any : row_binding::terms + term;
}

void Shading::bind(const ValueTable& values) const {
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, table_.name());
  for (int term = 0; term < int(terms_.size()); ++term)
    if (const int binding = binding_of(term); binding != row_binding::any) values.bind_row(binding, *terms_[std::size_t(term)].instance);
}

void Shading::bind_style(const Instance& renderer) const {
  glBindBufferRange(GL_UNIFORM_BUFFER, row_binding::style, table_.name(), GLintptr(std::size_t(renderer.number()) * sizeof(StyleRow)), sizeof(StyleRow));
}

std::uint64_t Shading::signature(ShaderLibrary& library) const {
  Hash hash;
  for (const Term& term : terms_) hash.add(term.file).add(term.properties).add(term.shared).add(library.revision(term.file));
  for (const Variant& variant : variants_) hash.add(variant);
  for (const auto& [renderer, interior] : interiors_) hash.add(renderer->number()).add(interior.row).add(interior.variant);
  return hash.value();
}

const SurfaceStyle& Shading::style(const Instance& renderer) const { return styles_.at(&renderer); }

std::string Shading::shade_case(const Variant& variant, LightKinds lights, bool own) const {
  const int ambient = variant.terms[0], diffuse = variant.terms[1], specular = variant.terms[2];
  const auto load = [&](int term, const char* component) {
    if (binding_of(term) != row_binding::any) return terms_[std::size_t(term)].prefix + "load(0)";
    return terms_[std::size_t(term)].prefix + "load(" + (own ? "lumen_own_style" : "lumen_styles[s.style]") + ".rows." + component + ")";
  };
  const auto declare = [&](int term, const char* name, const char* component) {
    return "    " + terms_[std::size_t(term)].prefix + "Properties " + name + " = " + load(term, component) + ";\n";
  };
  std::string text = "    r.ambient = ";
  text += ambient < 0 ? "s.ambient_color" : terms_[std::size_t(ambient)].prefix + "ambient(" + load(ambient, "x") + ", s)";
  text += ";\n";
  if (diffuse >= 0) text += declare(diffuse, "lumen_d", "y");
  if (specular >= 0) text += declare(specular, "lumen_s", "z");
  if (diffuse < 0 && specular < 0) return text;
  const char* const light = lights.points == 0 ? "directional_light(i)" : lights.points == lights.count ? "point_light(i, s.position)" : "light_at(i, s.position)";
  text += "    for (int i = 0; i < " + std::to_string(lights.count) + "; ++i) {\n      Light light = " + light + ";\n";
  if (diffuse >= 0) text += "      r.diffuse += " + terms_[std::size_t(diffuse)].prefix + "diffuse(lumen_d, s, light);\n";
  if (specular >= 0)
    text += "      if (dot(s.normal, light.direction) > 0.0) r.specular += " + terms_[std::size_t(specular)].prefix + "specular(lumen_s, s, light);\n";
  return text + "    }\n";
}

void Shading::write(ProgramText& text, lumen::Attenuates attenuates, LightKinds lights, bool with_opacity, const Instance* only) const {
  text.include("lib/values.glsl");
  text.include("host/styles.glsl");
  std::vector<int> met;  // variants
  if (only != nullptr) met.push_back(variant_of_.at(only));
  if (const auto inside = interiors_.find(only); inside != interiors_.end() && inside->second.variant != met.front()) met.push_back(inside->second.variant);
  if (only == nullptr)
    for (std::size_t v = 0; v < variants_.size(); ++v) met.push_back(int(v));
  // Styles at constant places are read faster than those that are looked up.
  const bool own = only != nullptr && !interiors_.contains(only);
  std::vector<bool> wanted(terms_.size(), false);
  for (const int v : met)
    for (std::size_t i = 0; i < 4; ++i)
      if (const int term = variants_[std::size_t(v)].terms[i]; term >= 0 && (i < 3 || with_opacity)) wanted[std::size_t(term)] = true;
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    if (!wanted[i]) continue;
    text.generated(properties_text(*terms_[i].instance, terms_[i].prefix, binding_of(int(i))));
    text.file(terms_[i].file, {lumen::name_of(terms_[i].instance->kind())}, terms_[i].prefix);
  }
  std::string cases;
  for (const int v : met) cases += "  case " + std::to_string(v) + ": {\n" + shade_case(variants_[std::size_t(v)], lights, own) + "  } break;\n";
  std::string function = "Lighting shade(Surface s, vec3 visibility) {\n  Lighting r = Lighting(vec3(0), vec3(0), vec3(0));\n";
  if (!cases.empty())
    function += "  switch (" + (met.size() == 1 && only != nullptr ? std::to_string(met.front()) : std::string("lumen_styles[s.style].variant.x")) + ") {\n" + cases + "  }\n";
  function += "  r.ambient *= visibility;\n";
  if (attenuates != lumen::Attenuates::ambient) function += "  r.diffuse *= visibility;\n";
  if (attenuates == lumen::Attenuates::everything) function += "  r.specular *= visibility;\n";
  function += "  return r;\n}\n";
  if (with_opacity) {
    const int term = only == nullptr ? -1 : variants_[std::size_t(met.front())].terms[3];
    function += "float opacity_of(Surface s) { return ";
    const std::string prefix = term < 0 ? "" : terms_[std::size_t(term)].prefix;
    function += term < 0 ? "1.0" : prefix + "opacity(" + prefix + "load(lumen_own_style.rows.w), s)";
    function += "; }\n";
  }
  text.generated(function);
}

}  // namespace lumenshop
