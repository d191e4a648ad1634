#include "frame/plugin_pass.h"

#include <algorithm>

#include <lumen/gl/framebuffer.h>

#include "frame/hash.h"
#include "frame/surface_pass.h"

namespace lumenshop {
namespace {

/// The GLSL function NAME_at(uv) over a sampler, with as many components as the format has.
std::string accessor(const std::string& name, const std::string& sampler, int channels) {
  const char* types[] = {"", "float", "vec2", "vec3", "vec4"};
  const char* swizzles[] = {"", ".r", ".rg", ".rgb", ""};
  return std::string(types[channels]) + " " + name + "_at(vec2 uv) { return textureLod(" + sampler + ", uv, 0.0)" + swizzles[channels] + "; }\n";
}

/// How many components a reader sees: packed extras are hidden.
int visible_channels(std::string_view layer, lumen::Format format) {
  return layer == "normal" || layer == "albedo" || layer == "ambient" || layer == "diffuse" || layer == "specular" ? 3 : lumen::channels_of(format);
}

void set_blend(GLuint target, lumen::Blend blend) {
  switch (blend) {
    case lumen::Blend::replace: glBlendFunci(target, GL_ONE, GL_ZERO); break;
    case lumen::Blend::add: glBlendFunci(target, GL_ONE, GL_ONE); break;
    case lumen::Blend::multiply_by_one_minus_source: glBlendFunci(target, GL_ZERO, GL_ONE_MINUS_SRC_COLOR); break;
    case lumen::Blend::over: glBlendFunci(target, GL_ONE, GL_ONE_MINUS_SRC_ALPHA); break;
  }
}

}  // namespace

PluginPass::PluginPass(const FrameContext& context, Instance& instance, PluginPassMemory& memory, LayerNames reads, LayerNames writes)
    : context_(context), instance_(instance), memory_(memory), reads_(std::move(reads)), writes_(std::move(writes)) {}

std::string PluginPass::stored(const LayerNames& names, const std::string& layer) const {
  const auto found = names.find(layer);
  return found == names.end() ? layer : found->second;
}

std::uint64_t PluginPass::key() const {
  Hash hash;
  hash.add(instance_.number()).add(instance_.draw_revision()).add(context_.geometry_key);
  for (const lumen::Reads* reads : instance_.plugin()->reads()) hash.add(context_.layers.revision(stored(reads_, reads->layer() == "position" ? "depth" : reads->layer())));
  for (const std::string& file : memory_.files) hash.add(context_.shaders.revision(file));
  if (memory_.uses_time) hash.add(context_.geometry.block.transparent_extent.w);
  if (instance_.kind() == lumen::Kind::transparency)
    hash.add(surfaces_key(context_, context_.scene.transparent)).add(context_.light_key).add(context_.shading.value_revision())
        .add(context_.shading.signature(context_.shaders)).add(context_.layers.revision("depth"));
  return hash.value();
}

bool PluginPass::run(const std::function<void(PluginPass&)>& draw) {
  for (const lumen::Writes* writes : instance_.plugin()->writes())
    context_.layers.allocate(stored(writes_, writes->layer()), writes->format(), size());
  const std::uint64_t base = key();
  if (context_.set == 0) {
    if (base != memory_.base_key) memory_.iteration = 0;
    else if (memory_.unfinished) ++memory_.iteration;
  }
  memory_.base_key = context_.set == 0 ? base : memory_.base_key;
  const std::uint64_t full = Hash().add(base).add(memory_.iteration).value();
  return context_.log.run(instance_.id(), context_.set, full, [&] {
    instance_.clear_reports();
    memory_.unfinished = false;
    try {
      draw(*this);
    } catch (const std::exception& error) {
      instance_.report(lumen::Severity::error, error.what());
    }
    for (const lumen::Writes* writes : instance_.plugin()->writes()) context_.layers.drawn(stored(writes_, writes->layer()));
    // What this run was the first to use belongs to its key from now on.
    memory_.base_key = context_.set == 0 ? key() : memory_.base_key;
    context_.log.set_key(instance_.id(), context_.set, Hash().add(key()).add(memory_.iteration).value());
  });
}

double PluginPass::time() const {
  memory_.uses_time = true;
  return double(context_.geometry.block.transparent_extent.w);
}

const lumen::gl::Texture& PluginPass::layer(const lumen::Reads& reads) const {
  const lumen::gl::Texture* texture = context_.layers.find(stored(reads_, reads.layer()));
  if (texture == nullptr) throw lumen::Error(instance_.id(), "reads layer '" + reads.layer() + "', which nothing in this view writes");
  return *texture;
}

const lumen::gl::Texture& PluginPass::layer(const lumen::Writes& writes) const {
  return *context_.layers.find(stored(writes_, writes.layer()));
}

const lumen::gl::Texture& PluginPass::scratch(std::string_view name, lumen::Format format, glm::ivec2 size) {
  return context_.layers.allocate(instance_.id() + "/" + std::string(name), format, size);
}

std::string PluginPass::accessors() const {
  std::string text;
  std::set<std::string> done;
  for (const lumen::Reads* reads : instance_.plugin()->reads()) {
    const std::string& layer = reads->layer();
    if (!done.insert(layer).second) continue;
    if (layer == "position") {
      if (done.insert("depth").second) text += "uniform sampler2D lumen_layer_depth;\n" + accessor("depth", "lumen_layer_depth", 1);
      text += "vec3 position_at(vec2 uv) { return position_from(uv, depth_at(uv)); }\n";
      continue;
    }
    const lumen::gl::Texture* texture = context_.layers.find(stored(reads_, layer));
    const lumen::Format format = texture == nullptr ? lumen::Format::R32F : texture->format();
    const std::string sampler = "lumen_layer_" + layer;
    const bool integers = format == lumen::Format::RGBA32UI;
    text += (integers ? "uniform usampler2D " : "uniform sampler2D ") + sampler + ";\n";
    text += integers ? "uvec4 " + layer + "_at(vec2 uv) { return textureLod(" + sampler + ", uv, 0.0); }\n"
                     : accessor(layer, sampler, visible_channels(layer, format));
  }
  return text;
}

void PluginPass::bind_layers(Program& program) const {
  for (const lumen::Reads* reads : instance_.plugin()->reads()) {
    const std::string layer = reads->layer() == "position" ? "depth" : reads->layer();
    if (const lumen::gl::Texture* texture = context_.layers.find(stored(reads_, layer))) program.bind("lumen_layer_" + layer, texture->name());
  }
}

void PluginPass::fullscreen(std::string_view shader, const lumen::FullscreenPass& pass) {
  const std::string file(shader);
  memory_.files.insert(file);
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
    std::string text = "uniform vec2 lumen_target_size;\n" + layers;
    for (const auto& [name, texture] : pass.inputs)
      text += std::string("uniform sampler2D ") + name + ";\n" + accessor(name, name, lumen::channels_of(texture->format()));
    fragment.generated(text + properties_text(instance_, prefix, row_binding::own));
    fragment.file(file, {pass.function}, prefix);
    fragment.generated("layout(location = 0) out vec4 lumen_result;\n"
                       "void main() {\n  Pixel pixel = Pixel(gl_FragCoord.xy / lumen_target_size, ivec2(gl_FragCoord.xy));\n"
                       "  lumen_result = " + prefix + pass.function + "(" + prefix + "load(0), pixel);\n}\n");
  });
  if (program == nullptr) throw lumen::Error(file, "the shader does not compile");
  const lumen::gl::Texture* depth_buffer = pass.covered_only && target.size() == size() ? context_.layers.find("depth_buffer") : nullptr;
  const lumen::gl::Texture* const targets[] = {&target};
  const lumen::gl::Framebuffer framebuffer(targets, depth_buffer);
  framebuffer.bind();
  glViewport(0, 0, target.size().x, target.size().y);
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

void PluginPass::surfaces(std::string_view shader, const char* function, std::span<const lumen::Target> targets, std::span<const glm::vec4> clear) {
  const std::string file(shader);
  memory_.files.insert(file);
  std::vector<const lumen::gl::Texture*> textures;
  for (const lumen::Target& target : targets) textures.push_back(target.texture);
  const lumen::gl::Framebuffer framebuffer(textures, context_.layers.find("depth_buffer"));
  framebuffer.bind();
  glViewport(0, 0, size().x, size().y);
  for (std::size_t i = 0; i < clear.size(); ++i) glClearNamedFramebufferfv(framebuffer.name(), GL_COLOR, GLint(i), &clear[i].x);
  Hash hash;
  hash.add(file).add(std::string_view(function)).add(properties_signature(instance_)).add(context_.shading.signature(context_.shaders)).add(context_.lights);
  for (const lumen::Target& target : targets) hash.add(std::string_view(target.name));
  const SurfaceOutput output{
      .name = instance_.id() + " " + function,
      .signature = hash.value(),
      .write = [&](ProgramText& text, const Instance& renderer) {
        const std::string prefix = prefix_of(file);
        context_.shading.write(text, lumen::Attenuates::ambient, context_.lights, true, &renderer);
        std::string head;
        for (std::size_t i = 0; i < targets.size(); ++i)
          head += "layout(location = " + std::to_string(i) + ") out vec4 " + targets[i].name + ";\n";
        text.generated(head + properties_text(instance_, prefix, row_binding::transparency));
        text.file(file, {function}, prefix);
        text.generated("void main() {\n  Surface s = lumen_surface();\n  Lighting l = shade(s, vec3(1));\n"
                       "  float alpha = clamp(opacity_of(s), 0.0, 1.0);\n  if (alpha <= 0.0) discard;\n"
                       "  Fragment fragment = Fragment(l.ambient + l.diffuse + l.specular, alpha, -s.position.z, s.instance, s.part, s.primitive);\n"
                       "  " + prefix + function + "(" + prefix + "load(0), fragment);\n}\n");
      },
      .prepare = [&](Program&) { context_.values.bind_row(row_binding::transparency, instance_); }};
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  for (std::size_t i = 0; i < targets.size(); ++i) set_blend(GLuint(i), targets[i].blend);
  for (const SceneSurface& surface : context_.scene.transparent) draw_surface(context_, surface, output);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
}

}  // namespace lumenshop
