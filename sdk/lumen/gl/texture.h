/// RAII names of GL objects. Move-only; made and destroyed with the context current.
#pragma once

#include <utility>
#include <vector>

#include <epoxy/gl.h>
#include <glm/vec2.hpp>

#include <lumen/layers.h>

namespace lumen::gl {

/// A 2-D texture without mipmaps, nearest, clamped to the edge.
class Texture {
 public:
  Texture() = default;
  Texture(Format format, glm::ivec2 size);
  Texture(Texture&& other) noexcept { swap(other); }
  Texture& operator=(Texture&& other) noexcept { swap(other); return *this; }
  ~Texture();

  GLuint name() const { return name_; }
  Format format() const { return format_; }
  glm::ivec2 size() const { return size_; }
  explicit operator bool() const { return name_ != 0; }
  /// Rows bottom-up, tightly packed, channels_of(format) floats per pixel.
  void upload(const float* pixels) const;
  void upload(const float* pixels, glm::ivec2 corner, glm::ivec2 size) const;  ///< a part of it
  void linear() const;  ///< bilinear from now on
  /// Reads it back: width * height * channels_of(format) floats (integers for UI formats, converted), rows bottom-up.
  std::vector<float> download() const;

 private:
  void swap(Texture& other) noexcept {
    std::swap(name_, other.name_);
    std::swap(format_, other.format_);
    std::swap(size_, other.size_);
  }
  GLuint name_ = 0;
  Format format_ = Format::RGBA8;
  glm::ivec2 size_{0};
};

}  // namespace lumen::gl
