/// What a plugin pass draws: full-screen triangles and transparent surfaces.
#include <algorithm>
#include <optional>

#include <lumen/gl/framebuffer.h>

#include "frame/coverage.h"
#include "frame/hash.h"
#include "frame/layer_text.h"
#include "frame/lighting_pass.h"
#include "frame/plugin_pass.h"
#include "frame/surface_draw.h"
#include "frame/surface_pass.h"
#include "frame/transparent_layers.h"

namespace lumenshop {
namespace {

/// How many components a reader sees: packed extras are hidden.
int visible_channels(std::string_view layer, lumen::Format format) {
  return layer == "normal" || layer == "front_normal" || layer == "albedo" || layer == "ambient" || layer == "diffuse" || layer == "specular" ? 3 : lumen::channels_of(format);
}

/// The accessor of a layer that nothing in the view writes: zero, with the components that it always has.
std::string absent(const std::string& layer) {
  const bool four = layer == "color" || layer == "transparent" || layer == "illumination";
  const std::string type = four ? "vec4" : layer == "id" ? "uvec4" : visible_channels(layer, lumen::Format::R32F) == 3 ? "vec3" : "float";
  return type + " " + layer + "_at(vec2 uv) { return " + type + "(0); }\n";
}

void set_blend(GLuint target, lumen::Blend blend) {
  glBlendEquationi(target, blend == lumen::Blend::maximum ? GL_MAX : GL_FUNC_ADD);
  switch (blend) {
    case lumen::Blend::replace: glBlendFunci(target, GL_ONE, GL_ZERO); break;
    case lumen::Blend::add: glBlendFunci(target, GL_ONE, GL_ONE); break;
    case lumen::Blend::multiply_by_one_minus_source: glBlendFunci(target, GL_ZERO, GL_ONE_MINUS_SRC_COLOR); break;
    case lumen::Blend::over: glBlendFunci(target, GL_ONE, GL_ONE_MINUS_SRC_ALPHA); break;
    case lumen::Blend::under: glBlendFunci(target, GL_ONE_MINUS_DST_ALPHA, GL_ONE); break;
    case lumen::Blend::maximum: glBlendFunci(target, GL_ONE, GL_ONE); break;
  }
}

/// What is drawn and cleared meanwhile stays within a box.
class Scissor {
 public:
  explicit Scissor(const PixelBox& box) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(box.begin.x, box.begin.y, std::max(box.size().x, 0), std::max(box.size().y, 0));
  }
  ~Scissor() { glDisable(GL_SCISSOR_TEST); }
  Scissor(const Scissor&) = delete;
  Scissor& operator=(const Scissor&) = delete;
};

}  // namespace

std::string PluginPass::accessors() const {
  std::string text;
  std::set<std::string> done;
  for (const lumen::Reads* reads : instance_.plugin()->reads()) {
    const std::string& layer = reads->layer();
    if (!done.insert(layer).second) continue;
    if (layer == "position") {
      if (done.insert("depth").second) text += "uniform sampler2D lumen_layer_depth;\n" + accessor_text("depth", "lumen_layer_depth", 1);
      text += "vec3 position_at(vec2 uv) { return position_from(uv, depth_at(uv)); }\n";
      continue;
    }
    const lumen::gl::Texture* texture = context_.layers.find(stored(reads_, layer));
    if (texture == nullptr) {
      text += absent(layer);
      continue;
    }
    const lumen::Format format = texture->format();
    const std::string sampler = "lumen_layer_" + layer;
    const bool integers = format == lumen::Format::RGBA32UI;
    text += (integers ? "uniform usampler2D " : "uniform sampler2D ") + sampler + ";\n";
    text += integers ? "uvec4 " + layer + "_at(vec2 uv) { return textureLod(" + sampler + ", uv, 0.0); }\n"
                     : accessor_text(layer, sampler, visible_channels(layer, format));
  }
  return text;
}

void PluginPass::bind_layers(Program& program) const {
  for (const lumen::Reads* reads : instance_.plugin()->reads()) {
    const std::string layer = reads->layer() == "position" ? "depth" : reads->layer();
    if (const lumen::gl::Texture* texture = context_.layers.find(stored(reads_, layer))) program.bind("lumen_layer_" + layer, texture->name());
  }
}

void PluginPass::use_file(const std::string& file) {
  memory_.files.insert(file);
  const auto& includes = context_.shaders.file(file).includes();
  if (std::find(includes.begin(), includes.end(), "lib/lights.glsl") != includes.end()) memory_.uses_lights = true;
}

void PluginPass::fullscreen(std::string_view shader, const lumen::FullscreenPass& pass) {
  const std::string file(shader);
  use_file(file);
  if (pass.target == nullptr && instance_.plugin()->writes().empty()) throw lumen::Error(instance_.id(), "draws without a target: it declares no Writes");
  const lumen::gl::Texture& target = pass.target != nullptr ? *pass.target : layer(*instance_.plugin()->writes().front());
  const std::string layers = accessors();
  Hash hash;
  hash.add(file).add(std::string_view(pass.function)).add(properties_signature(instance_)).add(layers);
  for (const auto& [name, texture] : pass.inputs) hash.add(std::string_view(name)).add(texture->format());
  Program* program = context_.shaders.program(instance_.id() + " " + pass.function, hash.value(), [&](ProgramText& vertex, ProgramText& fragment) {
    const std::string prefix = prefix_of(file);
    vertex.generated(fullscreen_triangle);
    fragment.include("lib/values.glsl");
    fragment.include("lib/frame.glsl");
    const std::string text = "uniform vec2 lumen_target_size;\n" + layers + inputs_text(pass.inputs);
    fragment.generated(text + properties_text(instance_, prefix, row_binding::own));
    fragment.file(file, {pass.function}, prefix);
    fragment.generated("layout(location = 0) out vec4 lumen_result;\n"
                       "void main() {\n  Pixel pixel = Pixel(gl_FragCoord.xy / lumen_target_size, ivec2(gl_FragCoord.xy));\n"
                       "  lumen_result = " + prefix + pass.function + "(" + prefix + "load(0), pixel);\n}\n");
  });
  if (program == nullptr) throw lumen::Error(file, "the shader does not compile");
  const lumen::gl::Texture* depth_buffer = pass.covered_only ? coverage(context_, stored(reads_, "depth_buffer"), target.size(), name_ + "/coverage") : nullptr;
  const lumen::gl::Texture* const targets[] = {&target};
  const lumen::gl::Framebuffer framebuffer(targets, depth_buffer);
  framebuffer.bind();
  glViewport(0, 0, target.size().x, target.size().y);
  std::optional<Scissor> scissor;
  if (instance_.kind() == lumen::Kind::transparency && target.size() == size()) scissor.emplace(pixels_);
  glDisable(GL_BLEND);
  if (depth_buffer != nullptr) {
    const float nothing[4] = {};
    glClearNamedFramebufferfv(framebuffer.name(), GL_COLOR, 0, nothing);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_FALSE);
  } else {
    glDisable(GL_DEPTH_TEST);
  }
  context_.bind(*program);
  context_.values.bind_row(row_binding::own, instance_);
  glProgramUniform2f(program->name(), glGetUniformLocation(program->name(), "lumen_target_size"), float(target.size().x), float(target.size().y));
  bind_layers(*program);
  for (const auto& [name, texture] : pass.inputs) program->bind(name, texture->name());
  draw_fullscreen_triangle();
  glDepthMask(GL_TRUE);
}

void PluginPass::surfaces(std::string_view shader, const lumen::SurfacesPass& pass) {
  const std::string file(shader);
  use_file(file);
  std::vector<const lumen::gl::Texture*> textures;
  for (const lumen::Target& target : pass.targets) textures.push_back(target.texture);
  const lumen::gl::Framebuffer framebuffer(textures, context_.layers.find("depth_buffer"));
  framebuffer.bind();
  glViewport(0, 0, size().x, size().y);
  const Scissor scissor(pixels_);
  for (std::size_t i = 0; i < pass.targets.size(); ++i)
    if (const auto& clear = pass.targets[i].clear) glClearNamedFramebufferfv(framebuffer.name(), GL_COLOR, GLint(i), &clear->x);
  Hash hash;
  hash.add(file).add(std::string_view(pass.function)).add(pass.lit).add(visibility_of(context_).attenuates).add(visibility_of(context_).layer)
      .add(transparent_occlusion_layers(context_)).add(properties_signature(instance_)).add(context_.shading.signature(context_.shaders)).add(context_.lights);
  for (const lumen::Target& target : pass.targets) hash.add(std::string_view(target.name));
  for (const auto& [name, texture] : pass.inputs) hash.add(std::string_view(name)).add(texture->format());
  const SurfaceOutput output{
      .name = instance_.id() + " " + pass.function,
      .signature = hash.value(),
      .write = [&](ProgramText& text, const Instance& renderer) { write_surfaces_text(text, file, pass, renderer); },
      .prepare = [&](Program& program) {
        context_.values.bind_row(row_binding::transparency, instance_);
        bind_transparent_occlusion(context_, program);
        for (const auto& [name, texture] : pass.inputs) program.bind(name, texture->name());
      }};
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  for (std::size_t i = 0; i < pass.targets.size(); ++i) set_blend(GLuint(i), pass.targets[i].blend);
  for (const SceneSurface& surface : context_.scene.transparent) draw_surface(context_, surface, output);
  glDisable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glDepthMask(GL_TRUE);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
}

void PluginPass::write_surfaces_text(ProgramText& text, const std::string& file, const lumen::SurfacesPass& pass, const Instance& renderer) const {
  const std::string prefix = prefix_of(file);
  context_.shading.write(text, visibility_of(context_).attenuates, context_.lights, true, &renderer);
  // What lies behind the opaque scene must not reach the plugin's storage.
  std::string head = "layout(early_fragment_tests) in;\n";
  for (std::size_t i = 0; i < pass.targets.size(); ++i)
    head += "layout(location = " + std::to_string(i) + ") out vec4 " + pass.targets[i].name + ";\n";
  head += inputs_text(pass.inputs) + transparent_visibility_text(context_);
  text.generated(head + properties_text(instance_, prefix, row_binding::transparency));
  text.file(file, {pass.function}, prefix);
  const std::string color = pass.lit ? "l.ambient + l.diffuse + l.specular" : "vec3(0)";
  text.generated(std::string("void main() {\n  Surface s = lumen_surface();\n") + (pass.lit ? "  Lighting l = shade(s, lumen_visibility_of(s));\n" : "") +
                 "  float alpha = clamp(opacity_of(s), 0.0, 1.0);\n  if (alpha <= 0.0) discard;\n"
                 "  Fragment fragment = Fragment(" + color + ", alpha, -s.position.z, s.instance, s.part, s.primitive);\n"
                 "  " + prefix + pass.function + "(" + prefix + "load(0), fragment);\n}\n");
}

}  // namespace lumenshop
