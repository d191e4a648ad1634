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

void begin(const lumen::gl::Framebuffer& target, glm::ivec2 size) {
  target.bind();
  glViewport(0, 0, size.x, size.y);
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
    begin(target, merged.size());
    Program* program = composite_program(context.shaders, "merge");
    if (program == nullptr) return;
    program->use();
    program->bind("lumen_source", layers.find("lit")->name());
    program->bind("lumen_over", layers.find("transparent")->name());
    draw_fullscreen_triangle();
    layers.drawn("merged");
  });
}

void accumulate(const FrameContext& context, const lumen::gl::Texture& source, LayerStore& sums, const std::string& sum, int count) {
  const lumen::gl::Texture& mean = sums.allocate(sum, lumen::Format::RGBA32F, source.size());
  const lumen::gl::Texture* const targets[] = {&mean};
  const lumen::gl::Framebuffer target(targets, nullptr);
  begin(target, mean.size());
  Program* program = composite_program(context.shaders, "copy");
  if (program == nullptr) return;
  program->use();
  program->bind("lumen_source", source.name());
  if (count > 0) {
    glEnable(GL_BLEND);
    glBlendColor(0, 0, 0, 1.0f / float(count + 1));
    glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
  }
  draw_fullscreen_triangle();
  glDisable(GL_BLEND);
  sums.drawn(sum);
}

}  // namespace lumenshop
