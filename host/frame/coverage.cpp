#include "frame/coverage.h"

#include <lumen/gl/framebuffer.h>

#include "frame/program_text.h"

namespace lumenshop {

const lumen::gl::Texture* coverage(const FrameContext& context, const std::string& depth_buffer, glm::ivec2 size, const std::string& name) {
  LayerStore& layers = context.layers;
  const lumen::gl::Texture* source = layers.find(depth_buffer);
  if (source == nullptr || source->size() == size) return source;
  const lumen::gl::Texture* before = layers.find(name);
  const bool due = before == nullptr || before->size() != size || layers.revision(name) < layers.revision(depth_buffer);
  const lumen::gl::Texture& result = layers.allocate(name, lumen::Format::depth32F, size);
  if (!due) return &result;
  Program* program = context.shaders.program("coverage", 1, [](ProgramText& vertex, ProgramText& fragment) {
    vertex.generated(fullscreen_triangle);
    fragment.include("host/coverage.glsl");
  });
  if (program == nullptr) return nullptr;
  const lumen::gl::Framebuffer target({}, &result);
  target.bind();
  glViewport(0, 0, size.x, size.y);
  glDisable(GL_BLEND);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_ALWAYS);
  glDepthMask(GL_TRUE);
  program->use();
  program->bind("lumen_depths", source->name());
  program->set("lumen_size", glm::vec4(size, source->size()));
  draw_fullscreen_triangle();
  layers.drawn(name);
  return &result;
}

}  // namespace lumenshop
