/// RAII GL vertex array.
#pragma once

#include <utility>

#include <lumen/gl/buffer.h>

namespace lumen::gl {

class VertexArray {
 public:
  VertexArray() = default;
  static VertexArray create();
  VertexArray(VertexArray&& other) noexcept { std::swap(name_, other.name_); }
  VertexArray& operator=(VertexArray&& other) noexcept { std::swap(name_, other.name_); return *this; }
  ~VertexArray();

  GLuint name() const { return name_; }
  explicit operator bool() const { return name_ != 0; }
  /// Feeds attribute `location` with `components` floats per vertex, `stride` bytes apart.
  void attribute(GLuint location, const Buffer& buffer, int components, int stride, std::size_t offset = 0) const;
  void elements(const Buffer& indices) const;  ///< 32-bit indices
  void bind() const;

 private:
  GLuint name_ = 0;
};

}  // namespace lumen::gl
