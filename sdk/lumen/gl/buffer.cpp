#include <lumen/gl/buffer.h>

namespace lumen::gl {

Buffer::Buffer(std::span<const std::byte> bytes, bool dynamic) : size_(bytes.size()) {
  glCreateBuffers(1, &name_);
  glNamedBufferData(name_, GLsizeiptr(size_), bytes.data(), dynamic ? GL_DYNAMIC_DRAW : GL_STATIC_DRAW);
}

Buffer::Buffer(std::size_t size) : size_(size) {
  glCreateBuffers(1, &name_);
  glNamedBufferData(name_, GLsizeiptr(size), nullptr, GL_DYNAMIC_COPY);
  glClearNamedBufferData(name_, GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE, nullptr);
}

Buffer::~Buffer() {
  if (name_ != 0) glDeleteBuffers(1, &name_);
}

void Buffer::write(std::span<const std::byte> bytes) {
  if (bytes.size() > size_ || name_ == 0) {
    *this = Buffer(bytes, true);
  } else {
    glNamedBufferSubData(name_, 0, GLsizeiptr(bytes.size()), bytes.data());
  }
}

}  // namespace lumen::gl
