/// RAII GL framebuffer.
#pragma once

#include <initializer_list>
#include <span>
#include <utility>

#include <lumen/gl/texture.h>

namespace lumen::gl {

class Framebuffer {
 public:
  Framebuffer() = default;
  /// Draws to `colors` in order; `depth` may be null. Throws Error if the GL refuses the combination.
  Framebuffer(std::span<const Texture* const> colors, const Texture* depth);
  Framebuffer(Framebuffer&& other) noexcept { std::swap(name_, other.name_); }
  Framebuffer& operator=(Framebuffer&& other) noexcept { std::swap(name_, other.name_); return *this; }
  ~Framebuffer();

  GLuint name() const { return name_; }
  explicit operator bool() const { return name_ != 0; }
  void bind() const;  ///< for drawing

 private:
  GLuint name_ = 0;
};

}  // namespace lumen::gl
