/// Walks around each point on OpenMesh's half-edges.
#include "crease.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "../connectivity.h"

namespace {

using Surface = Connectivity;
using Edge = OpenMesh::HalfedgeHandle;

constexpr std::size_t progress_step = 1 << 16;

/// False if the triangles are no manifold.
bool build(Surface& surface, std::size_t points, std::span<const glm::uvec3> triangles, const std::function<void(float)>& progress) {
  surface.reserve(points, triangles.size() * 3 / 2 + points, triangles.size());
  for (std::size_t point = 0; point < points; ++point) surface.add_vertex({});
  const auto handle = [](std::uint32_t index) { return OpenMesh::VertexHandle(static_cast<int>(index)); };
  for (std::size_t index = 0; index < triangles.size(); ++index) {
    if (index % progress_step == 0) progress(0.5f * static_cast<float>(index) / static_cast<float>(triangles.size()));
    const glm::uvec3 t = triangles[index];
    if (t.x == t.y || t.y == t.z || t.z == t.x) return false;
    if (!surface.add_face(handle(t.x), handle(t.y), handle(t.z)).is_valid()) return false;
  }
  return true;
}

glm::vec3 unit(glm::vec3 vector) {
  const float length = glm::length(vector);
  return length > 0 ? vector / length : glm::vec3(0);
}

class Splitter {
 public:
  Splitter(const Surface& surface, std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles, float crease, Weighting weighting)
      : surface_(surface), positions_(positions), input_(triangles), cosine_(std::cos(crease)), weighting_(weighting) {
    doubled_areas_.reserve(triangles.size());
    for (const glm::uvec3& t : triangles) doubled_areas_.push_back(glm::cross(positions[t.y] - positions[t.x], positions[t.z] - positions[t.x]));
    result_.triangles.assign(triangles.begin(), triangles.end());
    result_.normals.resize(positions.size());
    result_.sources.resize(positions.size());
    for (std::size_t point = 0; point < positions.size(); ++point) result_.sources[point] = static_cast<std::uint32_t>(point);
  }

  void split(std::uint32_t point) {
    gather(point);
    if (around_.empty()) return;
    const std::size_t count = around_.size();
    std::size_t begin = 0;
    while (begin < count && !is_separator(begin)) ++begin;
    if (begin == count) begin = 0;

    bool first = true;
    glm::vec3 sum(0);
    sector_.clear();
    const auto close = [&] {
      if (sector_.empty()) return;
      std::uint32_t target = point;
      if (!first) {
        target = static_cast<std::uint32_t>(result_.normals.size());
        result_.normals.emplace_back(0);
        result_.sources.push_back(point);
      }
      first = false;
      result_.normals[target] = unit(sum);
      for (const std::uint32_t face : sector_)
        for (int corner = 0; corner < 3; ++corner)
          if (input_[face][corner] == point) result_.triangles[face][corner] = target;
      sector_.clear();
      sum = glm::vec3(0);
    };
    for (std::size_t step = 0; step < count; ++step) {
      const std::size_t place = (begin + step) % count;
      if (step > 0 && is_separator(place)) close();
      if (const auto face = surface_.face_handle(around_[place]); face.is_valid()) {
        sector_.push_back(static_cast<std::uint32_t>(face.idx()));
        sum += weighted(static_cast<std::uint32_t>(face.idx()), point);
      }
    }
    close();
  }

  CreasedMesh take() { return std::move(result_); }

 private:
  /// The half-edges that leave the point, counterclockwise; the triangle left of each is the corner after it.
  void gather(std::uint32_t point) {
    around_.clear();
    const Edge start = surface_.halfedge_handle(OpenMesh::VertexHandle(static_cast<int>(point)));
    if (!start.is_valid()) return;
    Edge edge = start;
    do {
      around_.push_back(edge);
      edge = surface_.opposite_halfedge_handle(surface_.prev_halfedge_handle(edge));
    } while (edge != start);
  }

  bool is_separator(std::size_t place) const {
    const auto left = surface_.face_handle(around_[place]), right = surface_.face_handle(surface_.opposite_halfedge_handle(around_[place]));
    if (!left.is_valid() || !right.is_valid()) return true;
    const glm::vec3 a = doubled_areas_[static_cast<std::size_t>(left.idx())], b = doubled_areas_[static_cast<std::size_t>(right.idx())];
    const float lengths = glm::length(a) * glm::length(b);
    // A triangle without area has no normal to differ by.
    return lengths > 0 && glm::dot(a, b) < cosine_ * lengths;
  }

  glm::vec3 weighted(std::uint32_t face, std::uint32_t point) const {
    const glm::vec3 doubled = doubled_areas_[face];
    if (weighting_ == Weighting::area) return doubled;
    if (weighting_ == Weighting::uniform) return unit(doubled);
    const glm::uvec3 t = input_[face];
    const int corner = t.x == point ? 0 : t.y == point ? 1 : 2;
    const glm::vec3 a = positions_[t[(corner + 1) % 3]] - positions_[point], b = positions_[t[(corner + 2) % 3]] - positions_[point];
    return std::atan2(glm::length(doubled), glm::dot(a, b)) * unit(doubled);
  }

  const Surface& surface_;
  std::span<const glm::vec3> positions_;
  std::span<const glm::uvec3> input_;
  float cosine_;
  Weighting weighting_;
  std::vector<glm::vec3> doubled_areas_;   ///< per triangle: along its normal, twice its area long
  std::vector<Edge> around_;
  std::vector<std::uint32_t> sector_;
  CreasedMesh result_;
};

}  // namespace

std::optional<CreasedMesh> creased(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles, float crease, Weighting weighting,
                                   const std::function<void(float)>& progress) {
  // It prints every face that it refuses; we say so once.
  omerr().disable();
  Surface surface;
  if (!build(surface, positions.size(), triangles, progress)) return std::nullopt;
  Splitter splitter(surface, positions, triangles, crease, weighting);
  for (std::size_t point = 0; point < positions.size(); ++point) {
    if (point % progress_step == 0) progress(0.5f + 0.5f * static_cast<float>(point) / static_cast<float>(positions.size()));
    splitter.split(static_cast<std::uint32_t>(point));
  }
  return splitter.take();
}
