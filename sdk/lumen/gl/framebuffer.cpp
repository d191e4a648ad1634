#include <lumen/gl/framebuffer.h>

#include <vector>

#include <lumen/error.h>

namespace lumen::gl {

Framebuffer::Framebuffer(std::span<const Texture* const> colors, const Texture* depth) {
  glCreateFramebuffers(1, &name_);
  std::vector<GLenum> buffers;
  for (const Texture* color : colors) {
    const GLenum attachment = GL_COLOR_ATTACHMENT0 + GLenum(buffers.size());
    glNamedFramebufferTexture(name_, attachment, color->name(), 0);
    buffers.push_back(attachment);
  }
  if (depth != nullptr) glNamedFramebufferTexture(name_, GL_DEPTH_ATTACHMENT, depth->name(), 0);
  glNamedFramebufferDrawBuffers(name_, GLsizei(buffers.size()), buffers.data());
  if (glCheckNamedFramebufferStatus(name_, GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw Error("gl", "the driver refuses this combination of " + std::to_string(colors.size()) + " targets");
}

Framebuffer::~Framebuffer() {
  if (name_ != 0) glDeleteFramebuffers(1, &name_);
}

void Framebuffer::bind() const { glBindFramebuffer(GL_DRAW_FRAMEBUFFER, name_); }

}  // namespace lumen::gl
