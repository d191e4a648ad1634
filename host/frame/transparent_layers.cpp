#include "frame/transparent_layers.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include <lumen/gl/framebuffer.h>
#include <lumen/occlusion.h>

#include "frame/hash.h"
#include "frame/lighting_pass.h"
#include "frame/surface_draw.h"
#include "frame/surface_pass.h"

namespace lumenshop {
namespace {

constexpr int most_layers = 4;  // as View::occluded_layers allows
constexpr std::string_view layer_prefix = "transparent ";

/// The store's name of a layer of transparent layer `index`.
std::string name_of(int index, const std::string& layer) { return std::string(layer_prefix) + std::to_string(index) + "/" + layer; }

/// The opaque scene with the transparent surfaces of one layer in front of it. The depth buffer holds the latter alone, so
/// that full-screen passes visit their pixels only.
void run_layer_geometry(const FrameContext& context, int index) {
  LayerStore& layers = context.layers;
  const glm::ivec2 size = context.geometry.size();
  const lumen::gl::Texture& buffer = layers.allocate(name_of(index, "depth_buffer"), lumen::Format::depth32F, size);
  const lumen::gl::Texture& normal = layers.allocate(name_of(index, "normal"), lumen::Format::RGBA32F, size);
  const lumen::gl::Texture& depth = layers.allocate(name_of(index, "depth"), lumen::Format::R32F, size);
  const std::string nearer = index == 0 ? "" : name_of(index - 1, "depth");
  const std::uint64_t key = Hash().add(surfaces_key(context, context.scene.transparent)).add(layers.revision("depth")).add(layers.revision(nearer)).value();
  context.log.run("transparent layer " + std::to_string(index + 1), context.set, key, [&] {
    glCopyImageSubData(layers.find("normal")->name(), GL_TEXTURE_2D, 0, 0, 0, 0, normal.name(), GL_TEXTURE_2D, 0, 0, 0, 0, size.x, size.y, 1);
    glCopyImageSubData(layers.find("depth")->name(), GL_TEXTURE_2D, 0, 0, 0, 0, depth.name(), GL_TEXTURE_2D, 0, 0, 0, 0, size.x, size.y, 1);
    const lumen::gl::Texture* const targets[] = {&normal, &depth};
    const lumen::gl::Framebuffer target(targets, &buffer);
    target.bind();
    glViewport(0, 0, size.x, size.y);
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    const float one = 1;
    glClearNamedFramebufferfv(target.name(), GL_DEPTH, 0, &one);
    const SurfaceOutput output{
        .name = "transparent layer",
        .signature = Hash().add(index > 0).value(),
        .write = [&](ProgramText& text, const Instance&) {
          text.generated("uniform sampler2D lumen_opaque_depth, lumen_nearer_depth;\n"
                         "layout(location = 0) out vec4 lumen_normal;\nlayout(location = 1) out float lumen_depth;\n"
                         "void main() {\n  Surface s = lumen_surface();\n  ivec2 pixel = ivec2(gl_FragCoord.xy);\n  lumen_depth = -s.position.z;\n"
                         "  if (lumen_depth >= texelFetch(lumen_opaque_depth, pixel, 0).r) discard;\n" +
                         std::string(index > 0 ? "  if (lumen_depth <= texelFetch(lumen_nearer_depth, pixel, 0).r) discard;\n" : "") +
                         "  lumen_normal = vec4(s.normal, float(s.style));\n}\n");
        },
        .prepare = [&](Program& program) {
          program.bind("lumen_opaque_depth", layers.find("depth")->name());
          if (index > 0) program.bind("lumen_nearer_depth", layers.find(nearer)->name());
        },
        .front_suffices = index == 0};
    for (const SceneSurface& surface : context.scene.transparent) draw_surface(context, surface, output);
    for (const char* layer : {"depth_buffer", "normal", "depth"}) layers.drawn(name_of(index, layer));
  });
}

}  // namespace

int transparent_occlusion_layers(const FrameContext& context) {
  if (visibility_of(context).layer.empty() || context.scene.transparency == nullptr || context.scene.transparent.empty()) return 0;
  return context.scene.view->occluded_layers;
}

void run_transparent_layers(const FrameContext& context, std::map<std::string, PluginPassMemory>& memories, bool front) {
  const int count = transparent_occlusion_layers(context);
  const int drawn = front && !context.scene.transparent.empty() ? std::max(count, 1) : count;
  if (context.set == 0) {
    for (int i = 0; i < drawn; ++i) run_layer_geometry(context, i);
    for (int i = 0; i < count; ++i) {
      LayerNames reads, writes;
      for (const char* layer : {"depth", "normal", "depth_buffer"}) reads[layer] = name_of(i, layer);
      for (const char* layer : {"occlusion", "illumination"}) writes[layer] = name_of(i, layer);
      Instance& occlusion = *context.scene.occlusion;
      PluginPass pass(context, occlusion, memories[name_of(i, occlusion.id())], reads, writes, name_of(i, occlusion.id()));
      pass.run([&](PluginPass& in) { occlusion.as<lumen::Occlusion>(lumen::Kind::occlusion)->render(in); });
    }
    for (int i = count; i < most_layers; ++i)
      for (const char* layer : {"occlusion", "illumination"}) context.layers.drop(name_of(i, layer));
    for (int i = drawn; i < most_layers; ++i)
      for (const char* layer : {"depth_buffer", "normal", "depth"}) context.layers.drop(name_of(i, layer));
    std::erase_if(memories, [&](const auto& memory) {
      const auto& [name, contents] = memory;
      return name.starts_with(layer_prefix) && std::atoi(name.c_str() + layer_prefix.size()) >= count;
    });
  }
}

LayerNames front_layers(const LayerStore& layers) {
  const bool transparent = layers.find(name_of(0, "depth")) != nullptr;
  return {{"front_depth", transparent ? name_of(0, "depth") : "depth"}, {"front_normal", transparent ? name_of(0, "normal") : "normal"}, {"opaque", "lit"}};
}

std::uint64_t transparent_occlusion_revision(const FrameContext& context) {
  Hash hash;
  for (int i = 0; i < transparent_occlusion_layers(context); ++i) hash.add(context.centers.revision(name_of(i, visibility_of(context).layer)));
  return hash.value();
}

std::string transparent_visibility_text(const FrameContext& context) {
  const int count = transparent_occlusion_layers(context);
  std::string text, body;
  // The layer nearest in depth is the fragment's own, or the last one for what lies deeper.
  for (int i = 0; i < count; ++i) {
    const std::string number = std::to_string(i);
    text += "uniform sampler2D lumen_layer_depth_" + number + ", lumen_layer_visibility_" + number + ";\n";
    body += "  off = abs(textureLod(lumen_layer_depth_" + number + ", uv, 0.0).r + s.position.z);\n";
    body += "  if (off < nearest) { nearest = off; visibility = ";
    body += visibility_of(context).layer == "illumination" ? "textureLod(lumen_layer_visibility_" + number + ", uv, 0.0).rgb"
                                                  : "vec3(1.0 - textureLod(lumen_layer_visibility_" + number + ", uv, 0.0).r)";
    body += "; }\n";
  }
  return text + "uniform vec4 lumen_to_centers;\nvec3 lumen_visibility_of(Surface s) {\n  vec2 uv = gl_FragCoord.xy / lumen.size.xy * lumen_to_centers.xy + lumen_to_centers.zw;\n  float nearest = 1e30, off;\n  vec3 visibility = vec3(1);\n" +
         body + "  return visibility;\n}\n";
}

void bind_transparent_occlusion(const FrameContext& context, Program& program) {
  if (transparent_occlusion_layers(context) > 0) program.set("lumen_to_centers", context.to_centers);
  for (int i = 0; i < transparent_occlusion_layers(context); ++i) {
    program.bind("lumen_layer_depth_" + std::to_string(i), context.centers.find(name_of(i, "depth"))->name());
    program.bind("lumen_layer_visibility_" + std::to_string(i), context.centers.find(name_of(i, visibility_of(context).layer))->name());
  }
}

}  // namespace lumenshop
