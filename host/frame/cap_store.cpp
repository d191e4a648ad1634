#include "frame/cap_store.h"

namespace lumenshop {

void CapStore::draw(const std::shared_ptr<const lumen::Mesh>& shape) {
  if (shape->triangles.empty()) return;
  Buffers& buffers = held_[shape.get()];
  if (buffers.shape.lock() != shape) {
    std::erase_if(held_, [&](const auto& entry) { return entry.first != shape.get() && entry.second.shape.expired(); });
    buffers.shape = shape;
    buffers.positions = lumen::gl::Buffer(std::as_bytes(std::span<const glm::vec3>(shape->positions)));
    buffers.triangles = lumen::gl::Buffer(std::as_bytes(std::span<const glm::uvec3>(shape->triangles)));
    buffers.array = lumen::gl::VertexArray::create();
    buffers.array.attribute(0, buffers.positions, 3, sizeof(glm::vec3));
    buffers.array.elements(buffers.triangles);
  }
  buffers.array.bind();
  glDrawElements(GL_TRIANGLES, GLsizei(3 * shape->triangles.size()), GL_UNSIGNED_INT, nullptr);
}

}  // namespace lumenshop
