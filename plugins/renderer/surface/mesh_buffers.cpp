#include "mesh_buffers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string_view>

#include <lumen/error.h>

namespace {

/// Software GL holds a few hundred bytes for each triangle that is drawn and not yet rasterized, of as many as it is given.
constexpr std::size_t triangles_at_once = 1 << 14, parts_ahead = 4;

constexpr std::size_t tensor_size = 6;

/// Parts that were drawn, and that the GL still works on: a few at a time.
class PartsUnderWay {
 public:
  ~PartsUnderWay() {
    for (const GLsync done : done_) glDeleteSync(done);
  }
  /// Before another one: what was drawn may begin, and all but the last ones are done.
  void next() {
    if (count_ > 0) {
      done_[count_ % parts_ahead] = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
      glFlush();
    }
    GLsync& oldest = done_[++count_ % parts_ahead];
    if (oldest != nullptr) glClientWaitSync(oldest, GL_SYNC_FLUSH_COMMANDS_BIT, GL_TIMEOUT_IGNORED);
    glDeleteSync(oldest);
    oldest = nullptr;
  }

 private:
  std::array<GLsync, parts_ahead> done_{};
  std::size_t count_ = 0;
};

/// A buffer's contents, to be read. Where the GL is software, they are where they are: nothing is copied.
template <class T>
class MappedBuffer {
 public:
  explicit MappedBuffer(const lumen::gl::Buffer& buffer) : name_(buffer.name()), data_(static_cast<const T*>(glMapNamedBufferRange(name_, 0, GLsizeiptr(buffer.size()), GL_MAP_READ_BIT))) {
    if (data_ == nullptr) throw lumen::Error("renderer.surface", "the mesh's memory cannot be read", "close other programs that use much memory");
  }
  ~MappedBuffer() { glUnmapNamedBuffer(name_); }
  MappedBuffer(const MappedBuffer&) = delete;
  MappedBuffer& operator=(const MappedBuffer&) = delete;
  const T* data() const { return data_; }

 private:
  GLuint name_;
  const T* data_;
};

/// The GL runs on the cores that we run on.
bool gl_is_software() {
  const std::string_view renderer(reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
  return renderer.find("llvmpipe") != renderer.npos || renderer.find("softpipe") != renderer.npos;
}

/// The values in a new order, `width` of them at a time.
template <class T>
lumen::gl::Buffer ordered_buffer_of(std::span<const T> values, std::span<const std::uint32_t> order, std::size_t width = 1) {
  std::vector<T> ordered(order.size() * width);
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t k = 0; k < width; ++k) ordered[i * width + k] = values[order[i] * width + k];
  return lumen::gl::Buffer(std::as_bytes(std::span<const T>(ordered)));
}

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
    : groups_(std::move(groups)), clusters_(make_clusters(mesh, groups_)), software_(gl_is_software()) {
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
  const std::vector<std::uint32_t> order = number_points(clusters_, positions.size());
  positions_ = ordered_buffer_of(positions, order);
  array_.attribute(0, positions_, 3, sizeof(glm::vec3));
  if (!normals.empty()) {
    normals_ = ordered_buffer_of(normals, order);
    array_.attribute(1, normals_, 3, sizeof(glm::vec3));
  }
  if (!values.empty()) {
    values_ = ordered_buffer_of(values, order);
    array_.attribute(2, values_, 1, sizeof(float));
  }
  if (!curvatures.empty()) {
    curvatures_ = ordered_buffer_of(curvatures, order, tensor_size);
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

void MeshBuffers::draw(const Visibility& visibility, Coverage coverage) {
  visible_clusters(clusters_, visibility, seen_);
  if (seen_.empty()) return;
  if (visibility.skip_backs && visibility.openings.empty()) glEnable(GL_CULL_FACE);
  if (software_) draw_covering(coverage);
  else draw_runs();
  glDisable(GL_CULL_FACE);
}

void MeshBuffers::draw_runs() {
  runs_of(clusters_, seen_, runs_);
  std::size_t first = runs_[0].first, count = runs_[0].count;
  bind(triangles_);
  if (runs_.size() > 1) {
    const std::size_t gathered = std::accumulate(runs_.begin(), runs_.end(), std::size_t(0), [](std::size_t sum, const Run& run) { return sum + run.count; });
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
    first = 0;
    count = gathered;
  }
  glDrawElements(GL_TRIANGLES, GLsizei(count * 3), GL_UNSIGNED_INT, reinterpret_cast<const void*>(std::uintptr_t(first) * sizeof(glm::uvec3)));
}

void MeshBuffers::draw_covering(Coverage& coverage) {
  if (!visible_) visible_ = lumen::gl::Buffer(triangles_at_once * sizeof(glm::uvec3));
  bind(visible_);
  PartsUnderWay under_way;
  std::vector<glm::uvec3> whole, cut;
  whole.reserve(triangles_at_once);
  const auto draw = [&](std::vector<glm::uvec3>& triangles) {
    if (triangles.empty()) return;
    visible_.write(std::as_bytes(std::span(triangles)));
    under_way.next();
    glDrawElements(GL_TRIANGLES, GLsizei(triangles.size() * 3), GL_UNSIGNED_INT, nullptr);
    triangles.clear();
  };
  // What a plane cuts comes last: one cut triangle in a batch makes software GL take a slower way for all of the batch.
  for (auto seen = seen_.begin(); seen != seen_.end();) {
    {
      const MappedBuffer<glm::vec3> positions(positions_);
      const MappedBuffer<glm::uvec3> triangles(triangles_);
      for (; seen != seen_.end() && std::max(whole.size(), cut.size()) + cluster_size <= triangles_at_once; ++seen)
        coverage.gather(clusters_.clusters[seen->cluster], seen->backs, positions.data(), triangles.data(), seen->cut ? cut : whole);
    }
    draw(whole.size() >= cut.size() ? whole : cut);
  }
  draw(whole);
  draw(cut);
}
