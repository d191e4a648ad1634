/// A view's picture as the window shows it: sRGB bytes over the canvas color.
#pragma once

#include <glm/vec3.hpp>

#include <lumen/gl/framebuffer.h>
#include <lumen/gl/texture.h>
#include <lumen/gl/vertex_array.h>

namespace lumenshop {

class PictureTexture {
 public:
  PictureTexture();
  ~PictureTexture();
  PictureTexture(const PictureTexture&) = delete;
  PictureTexture& operator=(const PictureTexture&) = delete;

  /// Converts `picture`: linear, associated alpha. `encode`: to sRGB; `canvas`: sRGB, behind what is transparent.
  void update(const lumen::gl::Texture& picture, bool encode, glm::vec3 canvas, bool magnified);
  explicit operator bool() const { return static_cast<bool>(texture_); }
  const lumen::gl::Texture& texture() const { return texture_; }

 private:
  GLuint program_ = 0;
  lumen::gl::Texture texture_;
  lumen::gl::Framebuffer framebuffer_;
  lumen::gl::VertexArray vertices_;
};

}  // namespace lumenshop
