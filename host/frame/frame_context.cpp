#include "frame/frame_context.h"

#include <lumen/gl/vertex_array.h>

namespace lumenshop {

void FrameContext::bind(Program& program) const {
  program.use();
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, frame_block.name());
  glBindBufferBase(GL_UNIFORM_BUFFER, 1, light_block.name());
  values.bind(program);
  shading.bind(values);
}

void draw_fullscreen_triangle() {
  const auto empty = lumen::gl::VertexArray::create();
  empty.bind();
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace lumenshop
