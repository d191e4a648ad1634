#include "mesh_buffers.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace {

/// Software GL holds a few hundred bytes for each triangle that is drawn and not yet rasterized, of as many as it is given.
constexpr std::size_t triangles_at_once = 1 << 14, parts_ahead = 4;

constexpr std::size_t tensor_size = 6;

template <class T>
lumen::gl::Buffer buffer_of(std::span<const T> values) {
  return lumen::gl::Buffer(std::as_bytes(values));
}

}  // namespace

std::vector<float> shown_values(const lumen::Attribute& attribute) {
  const std::size_t components = std::size_t(attribute.components);
  std::vector<float> shown(attribute.values.size() / components);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (components == 1) {
      shown[i] = attribute.values[i];
    } else {
      float square = 0;
      for (std::size_t c = 0; c < components; ++c) square += attribute.values[i * components + c] * attribute.values[i * components + c];
      shown[i] = std::sqrt(square);
    }
  }
  return shown;
}

MeshBuffers::MeshBuffers(const lumen::Mesh& mesh, const lumen::Attribute* attribute, const lumen::Attribute* curvature, Groups groups)
    : groups_(std::move(groups)), clusters_(make_clusters(mesh, groups_)) {
  const std::span<const float> tensors = curvature == nullptr ? std::span<const float>() : curvature->values.view();
  if (attribute == nullptr || attribute->on == lumen::Attribute::On::points) {
    upload(mesh.positions, mesh.normals, attribute == nullptr ? std::vector<float>{} : shown_values(*attribute), tensors);
    return;
  }
  // A value per cell: points are no longer shared, each corner has its cell's value.
  const std::vector<float> cell_values = shown_values(*attribute);
  const std::vector<std::uint32_t> cells = drawn_cells(mesh, groups_);
  std::vector<glm::vec3> positions, normals;
  std::vector<float> values, curvatures;
  for (std::size_t i = 0; i < clusters_.triangles.size(); ++i) {
    glm::uvec3& triangle = clusters_.triangles[i];
    for (int corner = 0; corner < 3; ++corner) {
      positions.push_back(mesh.positions[triangle[corner]]);
      if (!mesh.normals.empty()) normals.push_back(mesh.normals[triangle[corner]]);
      values.push_back(cell_values[cells[i]]);
      if (!tensors.empty()) {
        const auto tensor = tensors.subspan(tensor_size * triangle[corner], tensor_size);
        curvatures.insert(curvatures.end(), tensor.begin(), tensor.end());
      }
    }
    triangle = glm::uvec3(3 * i) + glm::uvec3(0, 1, 2);
  }
  upload(positions, normals, values, curvatures);
}

void MeshBuffers::upload(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals, std::span<const float> values, std::span<const float> curvatures) {
  array_ = lumen::gl::VertexArray::create();
  positions_ = buffer_of(positions);
  array_.attribute(0, positions_, 3, sizeof(glm::vec3));
  if (!normals.empty()) {
    normals_ = buffer_of(normals);
    array_.attribute(1, normals_, 3, sizeof(glm::vec3));
  }
  if (!values.empty()) {
    values_ = buffer_of(values);
    array_.attribute(2, values_, 1, sizeof(float));
  }
  if (!curvatures.empty()) {
    curvatures_ = buffer_of(curvatures);
    array_.attribute(3, curvatures_, 3, tensor_size * sizeof(float));
    array_.attribute(4, curvatures_, 3, tensor_size * sizeof(float), 3 * sizeof(float));
  }
  triangles_ = buffer_of(std::span<const glm::uvec3>(clusters_.triangles));
  clusters_.triangles = {};  // the GL has them now
}

void MeshBuffers::bind(const lumen::gl::Buffer& indices) const {
  array_.elements(indices);
  array_.bind();
  glVertexAttrib3f(1, 0, 0, 0);  // what points without a normal read
  glVertexAttrib1f(2, 0);
}

void MeshBuffers::draw_group(const lumen::Mesh& mesh, int group, lumen::Draw& draw) {
  if (!cells_) cells_ = buffer_of(std::span<const std::uint32_t>(drawn_cells(mesh, groups_)));
  bind(triangles_);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 8, cells_.name());
  for (const Run& run : runs_of_group(clusters_, group)) {
    draw.number_from(int(run.first));
    glDrawElements(GL_TRIANGLES, GLsizei(run.count * 3), GL_UNSIGNED_INT, reinterpret_cast<const void*>(std::uintptr_t(run.first) * sizeof(glm::uvec3)));
  }
}

void MeshBuffers::draw_elements(std::size_t first, std::size_t count) const {
  std::array<GLsync, parts_ahead> done{};
  std::size_t part = 0;
  const auto wait = [&](GLsync& sync) {
    if (sync != nullptr) glClientWaitSync(sync, GL_SYNC_FLUSH_COMMANDS_BIT, GL_TIMEOUT_IGNORED);
    glDeleteSync(sync);
    sync = nullptr;
  };
  for (const std::size_t end = first + count; first < end; first += triangles_at_once) {
    const std::size_t some = std::min(triangles_at_once, end - first);
    GLsync& sync = done[part++ % parts_ahead];
    wait(sync);
    glDrawElements(GL_TRIANGLES, GLsizei(some * 3), GL_UNSIGNED_INT, reinterpret_cast<const void*>(std::uintptr_t(first) * sizeof(glm::uvec3)));
    if (count <= triangles_at_once) return;
    sync = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    glFlush();
  }
  for (GLsync sync : done) glDeleteSync(sync);
}

void MeshBuffers::draw(const Visibility& visibility) {
  visible_runs(clusters_, visibility, runs_);
  if (runs_.empty()) return;
  if (visibility.skip_backs && visibility.openings.empty()) glEnable(GL_CULL_FACE);
  if (runs_.size() == 1) {
    bind(triangles_);
    draw_elements(runs_[0].first, runs_[0].count);
  } else {
    std::size_t gathered = 0;
    for (const Run& run : runs_) gathered += run.count;
    const std::size_t size = gathered * sizeof(glm::uvec3);
    // Some room, so that it does not grow again with every frame of a moving camera.
    if (!visible_ || visible_.size() < size) visible_ = lumen::gl::Buffer(std::min(size + size / 4, triangles_.size()));
    GLintptr end = 0;
    for (const Run& run : runs_) {
      const GLsizeiptr bytes = GLsizeiptr(run.count * sizeof(glm::uvec3));
      glCopyNamedBufferSubData(triangles_.name(), visible_.name(), GLintptr(run.first * sizeof(glm::uvec3)), end, bytes);
      end += bytes;
    }
    bind(visible_);
    draw_elements(0, gathered);
  }
  glDisable(GL_CULL_FACE);
}
