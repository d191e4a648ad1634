#include "frame/surface_pass.h"

#include <algorithm>
#include <limits>

#include <glm/gtc/type_ptr.hpp>
#include <lumen/gl/framebuffer.h>
#include <lumen/renderer.h>

#include "frame/hash.h"

namespace lumenshop {
namespace {

/// The renderer's hand on a pass.
class SurfaceDraw final : public lumen::Draw {
 public:
  SurfaceDraw(const FrameContext& context, const SceneSurface& surface, const SurfaceOutput& output)
      : context_(context), surface_(surface), output_(output), world_to_clip_(context.geometry.world_to_clip()) {}
  ~SurfaceDraw() override {
    for (int i = 0; i < clip_distances_; ++i) glDisable(GLenum(GL_CLIP_DISTANCE0 + i));
  }

  const lumen::Camera& camera() const override { return context_.geometry.camera; }
  const glm::mat4& world_to_clip() const override { return world_to_clip_; }
  glm::ivec2 size() const override { return context_.geometry.size(); }
  bool front_suffices() const override { return output_.front_suffices && !surface_.split(); }
  bool identifies() const override { return output_.identifies; }
  std::span<const lumen::Part> parts() const override { return surface_.parts; }

  void use(std::string_view shader, int part, std::span<const std::pair<const char*, const lumen::gl::Texture*>> inputs) override {
    const lumen::Part& chosen = surface_.parts.at(std::size_t(part));
    const int planes = int(chosen.planes.size());
    Program* program = program_for(std::string(shader), planes, inputs);
    if (program == nullptr) throw lumen::Error(std::string(shader), "the shader does not compile");
    context_.bind(*program);
    context_.values.bind_row(row_binding::own, *surface_.instance);
    context_.shading.bind_style(*surface_.instance);
    program->set("lumen_instance", surface_.instance->number());
    program->set("lumen_part_index", part);
    program->set("lumen_part", chosen.transform);
    for (int i = 0; i < 8; ++i) (i < planes ? glEnable : glDisable)(GLenum(GL_CLIP_DISTANCE0 + i));
    clip_distances_ = planes;
    if (planes > 0)
      glProgramUniform4fv(program->name(), glGetUniformLocation(program->name(), "lumen_planes"), planes, glm::value_ptr(chosen.planes.front()));
    for (const auto& [name, texture] : inputs) program->bind(name, texture->name());
    if (output_.prepare) output_.prepare(*program);
  }

 private:
  Program* program_for(const std::string& file, int planes, std::span<const std::pair<const char*, const lumen::gl::Texture*>> inputs) {
    const Instance& instance = *surface_.instance;
    Hash hash;
    hash.add(file).add(planes).add(properties_signature(instance)).add(output_.signature);
    for (const auto& [name, texture] : inputs) hash.add(std::string_view(name));
    const std::string slot = instance.id() + " " + output_.name + (planes ? " cut by " + std::to_string(planes) : "");
    return context_.shaders.program(slot, hash.value(), [&](ProgramText& vertex, ProgramText& fragment) {
      const std::string prefix = prefix_of(file);
      const std::string properties = properties_text(instance, prefix, row_binding::own);
      std::string cut;
      if (planes > 0) {
        const std::string count = std::to_string(planes);
        cut += "uniform vec4 lumen_planes[" + count + "];\nout float gl_ClipDistance[" + count + "];\n";
        cut += "void lumen_cut(vec3 world) { for (int i = 0; i < " + count + "; ++i) gl_ClipDistance[i] = dot(lumen_planes[i], vec4(world, 1)); }\n";
      } else {
        cut += "void lumen_cut(vec3 world) {}\n";
      }
      vertex.generated(cut);
      vertex.include("lib/values.glsl");
      vertex.generated(properties);
      vertex.file(file, {"vertex"}, prefix);
      vertex.generated("void main() { " + prefix + "vertex(" + prefix + "load(0)); }\n");

      fragment.generated("uniform int lumen_instance, lumen_part_index;\nvoid lumen_cut(vec3 world) {}\n");
      for (const auto& [name, texture] : inputs) fragment.generated(std::string("uniform sampler2D ") + name + ";");
      fragment.include("lib/values.glsl");
      fragment.include("lib/frame.glsl");
      fragment.include("host/styles.glsl");
      fragment.generated(properties);
      fragment.file(file, {"surface"}, prefix);
      fragment.generated("Surface lumen_surface() {\n"
                         "  Surface s;\n"
                         "  s.instance = lumen_instance;\n  s.part = lumen_part_index;\n  s.primitive = 0;\n  s.front = gl_FrontFacing;\n"
                         "  lumen_own_material(s);\n  " + prefix + "surface(" + prefix + "load(0), s);\n"
                         "  s.to_eye = to_eye(s.position);\n"
                         "  s.normal = lumen_facing(s.normal, s.to_eye, cross(dFdx(s.position), dFdy(s.position)));\n"
                         "  return s;\n}\n");
      output_.write(fragment, instance);
    });
  }

  const FrameContext& context_;
  const SceneSurface& surface_;
  const SurfaceOutput& output_;
  glm::mat4 world_to_clip_;
  int clip_distances_ = 0;
};

}  // namespace

void draw_surface(const FrameContext& context, const SceneSurface& surface, const SurfaceOutput& output) {
  try {
    SurfaceDraw draw(context, surface, output);
    surface.instance->as<lumen::Renderer>(lumen::Kind::renderer)->draw(draw);
  } catch (const std::exception& error) {
    surface.instance->report(lumen::Severity::error, error.what());
  }
}

std::uint64_t surfaces_key(const FrameContext& context, const std::vector<SceneSurface>& surfaces) {
  Hash hash;
  if (surfaces.empty()) return hash.add(context.geometry.size()).value();  // nothing, wherever one looks
  hash.add(context.geometry_key);
  for (const SceneSurface& surface : surfaces) {
    hash.add(surface.instance->number()).add(surface.instance->draw_revision());
    if (surface.splitter != nullptr) hash.add(surface.splitter->number()).add(surface.splitter->draw_revision());
    std::string file = surface.instance->type();
    std::replace(file.begin(), file.end(), '.', '/');
    hash.add(context.shaders.revision(file + ".glsl"));
  }
  return hash.value();
}

void run_geometry_pass(const FrameContext& context, GeometryLayers wanted) {
  LayerStore& layers = context.layers;
  const glm::ivec2 size = context.geometry.size();
  const lumen::gl::Texture& depth_buffer = layers.allocate("depth_buffer", lumen::Format::depth32F, size);
  const lumen::gl::Texture& normal = layers.allocate("normal", lumen::Format::RGBA32F, size);
  const lumen::gl::Texture& depth = layers.allocate("depth", lumen::Format::R32F, size);
  std::vector<const lumen::gl::Texture*> targets = {&normal, &depth};
  std::string declarations = "layout(location = 0) out vec4 lumen_normal;\nlayout(location = 1) out float lumen_depth;\n";
  std::string writes = "  lumen_normal = vec4(s.normal, float(s.instance));\n  lumen_depth = -s.position.z;\n";
  if (wanted.albedo) {
    declarations += "layout(location = " + std::to_string(targets.size()) + ") out vec4 lumen_albedo;\n";
    writes += "  lumen_albedo = vec4(s.diffuse_color, 1);\n";
    targets.push_back(&layers.allocate("albedo", lumen::Format::RGBA16F, size));
  } else {
    layers.drop("albedo");
  }
  if (wanted.id) {
    declarations += "layout(location = " + std::to_string(targets.size()) + ") out uvec4 lumen_id;\n";
    writes += "  lumen_id = uvec4(s.instance, s.part + 1, s.primitive + 1, 0);\n";
    targets.push_back(&layers.allocate("id", lumen::Format::RGBA32UI, size));
  }
  const SurfaceOutput output{
      .name = "geometry",
      .signature = Hash().add(wanted).value(),
      .write = [&](ProgramText& text, const Instance&) {
        text.generated(declarations + "void main() {\n  Surface s = lumen_surface();\n" + writes + "}\n");
      },
      .front_suffices = true,
      .identifies = wanted.id};
  const std::uint64_t key = Hash().add(surfaces_key(context, context.scene.opaque)).add(output.signature).value();
  context.log.run("geometry", context.set, key, [&] {
    const lumen::gl::Framebuffer target(targets, &depth_buffer);
    target.bind();
    glViewport(0, 0, size.x, size.y);
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    const float nothing[4] = {}, far[4] = {std::numeric_limits<float>::infinity(), 0, 0, 0}, one = 1;
    const GLuint no_id[4] = {};
    for (std::size_t i = 0; i < targets.size(); ++i) {
      if (targets[i]->format() == lumen::Format::RGBA32UI) glClearNamedFramebufferuiv(target.name(), GL_COLOR, GLint(i), no_id);
      else glClearNamedFramebufferfv(target.name(), GL_COLOR, GLint(i), targets[i] == &depth ? far : nothing);
    }
    glClearNamedFramebufferfv(target.name(), GL_DEPTH, 0, &one);
    for (const SceneSurface& surface : context.scene.opaque) draw_surface(context, surface, output);
    for (const char* layer : {"depth_buffer", "normal", "depth", "albedo", "id"}) layers.drawn(layer);
  });
}

}  // namespace lumenshop
