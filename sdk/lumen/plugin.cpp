#include <lumen/plugin.h>

#include <lumen/renderer.h>

namespace lumen {

std::string_view name_of(Kind kind) {
  switch (kind) {
    case Kind::importer: return "importer";
    case Kind::exporter: return "exporter";
    case Kind::filter: return "filter";
    case Kind::renderer: return "renderer";
    case Kind::ambient: return "ambient";
    case Kind::diffuse: return "diffuse";
    case Kind::specular: return "specular";
    case Kind::opacity: return "opacity";
    case Kind::splitter: return "splitter";
    case Kind::occlusion: return "occlusion";
    case Kind::transparency: return "transparency";
    case Kind::compositor: return "compositor";
    case Kind::interactor: return "interactor";
    case Kind::editor: return "editor";
    case Kind::view: return "view";
  }
  return "";
}

Plugin::Plugin(Binding& binding) : binding_(binding) {}
Plugin::~Plugin() = default;

Observer::Observer(Plugin* owner, std::string property) : owner_(owner), property_(std::move(property)) {
  owner_->binding().observe(property_, +1);
}
Observer::~Observer() { owner_->binding().observe(property_, -1); }

Reads::Reads(Plugin* owner, std::string layer, int border) : owner_(owner), layer_(std::move(layer)), border_(border) { owner_->reads_.push_back(this); }
Reads::~Reads() { std::erase(owner_->reads_, this); }

Writes::Writes(Plugin* owner, std::string layer, Format format) : owner_(owner), layer_(std::move(layer)), format_(format) { owner_->writes_.push_back(this); }
Writes::~Writes() { std::erase(owner_->writes_, this); }

int channels_of(Format format) {
  switch (format) {
    case Format::R8: case Format::R16F: case Format::R32F: case Format::R32UI: case Format::depth32F: return 1;
    case Format::RG8: case Format::RG16F: case Format::RG32F: case Format::RG32UI: return 2;
    case Format::RGBA8: case Format::RGBA16F: case Format::RGBA32F: case Format::RGBA32UI: return 4;
  }
  return 0;
}

// Default diffuse: sRGB (220, 56, 63.5), in linear light.
Style::Style(Plugin* owner)
    : ambient(owner, "ambient", {}, {.doc = "ambient term; none: the ambient color as it is", .group = "Shading", .accepts = "ambient", .affects = Affects::shading}),
      diffuse(owner, "diffuse", {}, {.doc = "diffuse term; none: no diffuse light", .group = "Shading", .accepts = "diffuse", .affects = Affects::shading}),
      specular(owner, "specular", {}, {.doc = "specular term; none: no highlights", .group = "Shading", .accepts = "specular", .affects = Affects::shading}),
      opacity(owner, "opacity", {}, {.doc = "opacity term; none: opaque", .group = "Shading", .accepts = "opacity"}),
      ambient_color(owner, "ambient_color", Color(0.3f, 0.0166f, 0.0211f), {.min = 0, .max = 1, .doc = "material color of the ambient term", .group = "Material", .affects = Affects::shading}),
      diffuse_color(owner, "diffuse_color", Color(0.715694f, 0.039546f, 0.050371f), {.min = 0, .max = 1, .doc = "material color of the diffuse term", .group = "Material", .affects = Affects::shading}),
      specular_color(owner, "specular_color", Color(0.3f, 0.3f, 0.3f), {.min = 0, .max = 1, .doc = "material color of the specular term", .group = "Material", .affects = Affects::shading}),
      shininess(owner, "shininess", 40.0f, {.min = 0.1, .max = 1000, .doc = "exponent of the specular term", .group = "Material", .logarithmic = true, .affects = Affects::shading}) {}

}  // namespace lumen
