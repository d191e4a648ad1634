#include "frame/composite_pass.h"

#include <lumen/gl/framebuffer.h>

#include "frame/hash.h"
#include "frame/program_text.h"

namespace lumenshop {
namespace {

Program* composite_program(ShaderLibrary& shaders, const std::string& function) {
  return shaders.program("composite " + function, 1, [&](ProgramText& vertex, ProgramText& fragment) {
    vertex.generated(fullscreen_triangle);
    fragment.include("host/composite.glsl");
    fragment.generated("void main() { " + function + "(); }\n");
  });
}

void begin(const lumen::gl::Framebuffer& target, const PixelBox& pixels) {
  target.bind();
  glViewport(pixels.begin.x, pixels.begin.y, pixels.size().x, pixels.size().y);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
}

}  // namespace

void run_merge_pass(const FrameContext& context) {
  LayerStore& layers = context.layers;
  const lumen::gl::Texture& merged = layers.allocate("merged", lumen::Format::RGBA32F, context.geometry.size());
  const std::uint64_t key = Hash().add(layers.revision("lit")).add(layers.revision("transparent")).value();
  context.log.run("merge", context.set, key, [&] {
    const lumen::gl::Texture* const targets[] = {&merged};
    const lumen::gl::Framebuffer target(targets, nullptr);
    begin(target, {{0, 0}, merged.size()});
    Program* program = composite_program(context.shaders, "merge");
    if (program == nullptr) return;
    program->use();
    program->bind("lumen_source", layers.find("lit")->name());
    program->bind("lumen_over", layers.find("transparent")->name());
    draw_fullscreen_triangle();
    layers.drawn("merged");
  });
}

void add_to_mean(const FrameContext& context, const lumen::gl::Texture& source, const lumen::gl::Texture& mean, const PixelBox& pixels, int rounds) {
  const lumen::gl::Texture* const targets[] = {&mean};
  const lumen::gl::Framebuffer framebuffer(targets, nullptr);
  begin(framebuffer, pixels);
  Program* program = composite_program(context.shaders, "mean");
  if (program == nullptr) return;
  program->use();
  program->bind("lumen_source", source.name());
  program->set("lumen_begin", glm::vec4(pixels.begin, context.geometry.border, 0));
  if (rounds > 0) {
    glEnable(GL_BLEND);
    glBlendColor(0, 0, 0, 1.0f / float(rounds + 1));
    glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
  }
  draw_fullscreen_triangle();
  glDisable(GL_BLEND);
}

void pick_samples(const FrameContext& context, LayerStore& centers, const PixelBox& pixels) {
  const LayerStore& samples = context.layers;
  const lumen::gl::Texture* const targets[] = {centers.find("normal"), centers.find("depth")};
  const lumen::gl::Framebuffer framebuffer(targets, centers.find("depth_buffer"));
  begin(framebuffer, pixels);
  Program* program = composite_program(context.shaders, "pick");
  if (program == nullptr) return;
  program->use();
  program->bind("lumen_source", samples.find("normal")->name());
  program->bind("lumen_over", samples.find("depth")->name());
  program->bind("lumen_depths", samples.find("depth_buffer")->name());
  program->set("lumen_begin", glm::vec4(pixels.begin, context.geometry.border, 0));
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_ALWAYS);
  glDepthMask(GL_TRUE);
  draw_fullscreen_triangle();
  for (const char* layer : {"normal", "depth", "depth_buffer"}) centers.drawn(layer);
}

void add_attenuated(const FrameContext& context, const lumen::gl::Texture& open, const std::string& occlusion_layer, const lumen::gl::Texture& sum,
                    const PixelBox& pixels) {
  const lumen::gl::Texture* const targets[] = {&sum};
  const lumen::gl::Framebuffer framebuffer(targets, nullptr);
  begin(framebuffer, pixels);
  const lumen::gl::Texture* occlusion = context.layers.find(occlusion_layer);
  Program* program = composite_program(context.shaders, occlusion == nullptr ? "shifted" : occlusion_layer == "occlusion" ? "unoccluded" : "illuminated");
  if (program == nullptr) return;
  program->use();
  program->bind("lumen_source", open.name());
  program->set("lumen_begin", glm::vec4(pixels.begin, 0, 0));
  if (occlusion != nullptr) program->bind("lumen_over", occlusion->name());
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  draw_fullscreen_triangle();
  glDisable(GL_BLEND);
}

}  // namespace lumenshop
