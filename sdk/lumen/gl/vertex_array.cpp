#include <lumen/gl/vertex_array.h>

namespace lumen::gl {

VertexArray VertexArray::create() {
  VertexArray result;
  glCreateVertexArrays(1, &result.name_);
  return result;
}

VertexArray::~VertexArray() {
  if (name_ != 0) glDeleteVertexArrays(1, &name_);
}

void VertexArray::attribute(GLuint location, const Buffer& buffer, int components, int stride, std::size_t offset) const {
  glVertexArrayVertexBuffer(name_, location, buffer.name(), GLintptr(offset), stride);
  glVertexArrayAttribFormat(name_, location, components, GL_FLOAT, GL_FALSE, 0);
  glVertexArrayAttribBinding(name_, location, location);
  glEnableVertexArrayAttrib(name_, location);
}

void VertexArray::elements(const Buffer& indices) const { glVertexArrayElementBuffer(name_, indices.name()); }
void VertexArray::bind() const { glBindVertexArray(name_); }

}  // namespace lumen::gl
