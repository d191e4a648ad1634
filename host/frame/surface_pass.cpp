#include "frame/surface_pass.h"

#include <limits>

#include <lumen/gl/framebuffer.h>

#include "frame/hash.h"
#include "frame/layer_text.h"
#include "frame/surface_draw.h"

namespace lumenshop {
namespace {

/// Splits may depend on more than properties: on the camera, on time.
void add_split(Hash& hash, const lumen::Split& split) {
  hash.add(split.groups.get());
  for (const lumen::Part& part : split.parts) {
    hash.add(part.transform).add(part.group).add(part.removable);
    for (const glm::vec4& plane : part.planes) hash.add(plane);
  }
  for (const lumen::Cap& cap : split.caps) hash.add(cap.part).add(cap.plane).add(cap.shape.get());
}

}  // namespace

std::uint64_t surfaces_key(const FrameContext& context, const std::vector<SceneSurface>& surfaces) {
  Hash hash;
  if (surfaces.empty()) return hash.add(context.geometry.size()).value();  // nothing, wherever one looks
  hash.add(context.geometry_key);
  bool removes = false;
  for (const SceneSurface& surface : surfaces) {
    hash.add(surface.instance->number()).add(surface.instance->draw_revision());
    hash.add(context.shaders.revision(shader_file(*surface.instance))).add(context.shading.interior_row(*surface.instance));
    for (const Instance* splitter : surface.splitters) hash.add(splitter->number()).add(splitter->draw_revision()).add(context.shaders.revision(shader_file(*splitter)));
    add_split(hash, surface.split);
    removes = removes || surface.removes();
  }
  // What is removed may depend on any surface.
  if (removes)
    for (const auto* list : {&context.scene.opaque, &context.scene.transparent})
      for (const SceneSurface& surface : *list) hash.add(surface.instance->number()).add(surface.instance->draw_revision());
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
  std::string writes = "  lumen_normal = vec4(s.normal, float(s.style));\n  lumen_depth = -s.position.z;\n";
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
