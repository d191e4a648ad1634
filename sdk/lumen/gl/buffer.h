/// RAII GL buffer.
#pragma once

#include <cstddef>
#include <span>
#include <utility>

#include <epoxy/gl.h>

namespace lumen::gl {

class Buffer {
 public:
  Buffer() = default;
  /// Holds a copy of `bytes`; `dynamic` if it will be written again.
  explicit Buffer(std::span<const std::byte> bytes, bool dynamic = false);
  explicit Buffer(std::size_t size);  ///< zeroed, writable
  Buffer(Buffer&& other) noexcept { swap(other); }
  Buffer& operator=(Buffer&& other) noexcept { swap(other); return *this; }
  ~Buffer();

  GLuint name() const { return name_; }
  std::size_t size() const { return size_; }
  explicit operator bool() const { return name_ != 0; }
  /// Replaces the contents, growing if needed (the name may change).
  void write(std::span<const std::byte> bytes);

 private:
  void swap(Buffer& other) noexcept {
    std::swap(name_, other.name_);
    std::swap(size_, other.size_);
  }
  GLuint name_ = 0;
  std::size_t size_ = 0;
};

}  // namespace lumen::gl
