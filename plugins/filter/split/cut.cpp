/// The cut on OpenMesh's half-edges: each edge that crosses the plane is split once, which splits the triangles beside it, so that
/// what lies above and what lies below meet in edges of the plane. The cut's lines are borders of what lies above, walked around
/// their points.
#include "cut.h"

#include <cfloat>
#include <optional>

#include <glm/geometric.hpp>
#include <lumen/components.h>

#include "../connectivity.h"
#include "sheets.h"

namespace {

using Surface = Connectivity;
using HalfEdge = OpenMesh::HalfedgeHandle;
using Face = OpenMesh::FaceHandle;

constexpr std::size_t progress_step = 1 << 16;
const Surface::Point nowhere(0, 0, 0);  // nobody asks

/// Which side of the plane a point is on.
enum class Place : std::uint8_t { below, on, above, whole };

OpenMesh::VertexHandle handle(std::uint32_t point) { return OpenMesh::VertexHandle(int(point)); }
std::uint32_t number(OpenMesh::VertexHandle point) { return std::uint32_t(point.idx()); }

class Cutter {
 public:
  Cutter(const lumen::Mesh& mesh, const glm::dvec4& plane, const std::vector<bool>& whole) : mesh_(mesh), plane_(plane), whole_(whole) { surface_.add_property(source_); }

  Cut run(const std::function<void(float)>& progress) {
    build(progress);
    place_points();
    split_edges();
    progress(0.8f);
    choose_sides();
    trace_loops();
    gather();
    return std::move(cut_);
  }

 private:
  double height(std::uint32_t point) const { return glm::dot(glm::dvec3(plane_), glm::dvec3(mesh_.positions[point])) + plane_.w; }

  void build(const std::function<void(float)>& progress) {
    std::vector<glm::uvec3> triangles;
    std::vector<std::uint32_t> sources;
    triangles.reserve(mesh_.triangles.size());
    sources.reserve(mesh_.triangles.size());
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
      const glm::uvec3 t = mesh_.triangles[i];
      if (t.x == t.y || t.y == t.z || t.z == t.x) continue;  // covers nothing
      triangles.push_back(t);
      sources.push_back(std::uint32_t(i));
    }
    if (!add(triangles, sources, true, [&](float part) { progress(0.7f * part); })) {
      surface_.clear();
      const Sheets sheets = sheets_of(mesh_.positions, triangles);
      cut_.parted = sheets.copies.size();
      cut_.turned = sheets.turned;
      cut_.doubles = triangles.size() - sheets.triangles.size();
      for (std::size_t i = 0; i < sheets.sources.size(); ++i) sources[i] = sources[sheets.sources[i]];
      for (const std::uint32_t point : sheets.copies) cut_.added.push_back({point, point, 0});
      add(sheets.triangles, sources, false, [&](float part) { progress(0.35f + 0.35f * part); });
    }
    for (const auto edge : surface_.edges()) cut_.border_edges += surface_.is_boundary(edge) ? 1 : 0;
  }

  /// `strict`: stops with false at a triangle that does not fit; else such a one gets points of its own.
  bool add(std::span<const glm::uvec3> triangles, std::span<const std::uint32_t> sources, bool strict, const std::function<void(float)>& progress) {
    const std::size_t points = mesh_.positions.size() + cut_.added.size();
    surface_.reserve(points + points / 16, triangles.size() * 3 / 2 + points, triangles.size() + triangles.size() / 16);
    for (std::size_t point = 0; point < points; ++point) surface_.add_vertex(nowhere);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      if (i % progress_step == 0) progress(float(i) / float(triangles.size()));
      const glm::uvec3& t = triangles[i];
      Face face = surface_.add_face(handle(t.x), handle(t.y), handle(t.z));
      if (!face.is_valid()) {
        if (strict) return false;
        face = surface_.add_face(copy_of(t.x), copy_of(t.y), copy_of(t.z));
        ++cut_.unfit;
      }
      surface_.property(source_, face) = sources[i];
    }
    return true;
  }

  OpenMesh::VertexHandle copy_of(std::uint32_t point) {
    const std::uint32_t source = cut_.origin(point, mesh_.positions.size()).from;
    cut_.added.push_back({source, source, 0});
    return surface_.add_vertex(nowhere);
  }

  void place_points() {
    const lumen::Bounds box = mesh_.bounds();
    const glm::dvec3 farthest = glm::max(glm::abs(glm::dvec3(box.min)), glm::abs(glm::dvec3(box.max)));
    // Points closer to the plane than this cannot be told from points of the cut, which are rounded, too.
    constexpr double roundings = 32;
    const double error = roundings * double(FLT_EPSILON) * glm::dot(glm::abs(glm::dvec3(plane_)), farthest);
    places_.resize(surface_.n_vertices());
    for (std::uint32_t point = 0; point < places_.size(); ++point) {
      const double s = height(cut_.origin(point, mesh_.positions.size()).from);
      places_[point] = std::abs(s) <= error ? Place::on : s > 0 ? Place::above : Place::below;
    }
    if (whole_.empty()) return;
    for (const auto face : surface_.faces())
      if (whole_[surface_.property(source_, face)])
        for (const auto point : surface_.fv_range(face)) places_[std::size_t(point.idx())] = Place::whole;
  }

  void split_edges() {
    const std::size_t count = surface_.n_edges();  // new edges have an end on the plane
    for (std::size_t i = 0; i < count; ++i) {
      const OpenMesh::EdgeHandle edge = surface_.edge_handle(unsigned(i));
      const HalfEdge half = surface_.halfedge_handle(edge, 0);
      const std::uint32_t a = number(surface_.from_vertex_handle(half)), b = number(surface_.to_vertex_handle(half));
      const bool crosses = (places_[a] == Place::above && places_[b] == Place::below) || (places_[a] == Place::below && places_[b] == Place::above);
      if (!crosses) continue;
      const std::uint32_t from = cut_.origin(a, mesh_.positions.size()).from, to = cut_.origin(b, mesh_.positions.size()).from;
      const double at_from = height(from), at_to = height(to);
      cut_.added.push_back({from, to, float(at_from / (at_from - at_to))});
      places_.push_back(Place::on);
      surface_.split_copy(edge, surface_.add_vertex(nowhere));
    }
  }

  void choose_sides() {
    cut_.sides.reserve(surface_.n_faces());
    for (const auto face : surface_.faces()) {
      std::optional<Side> side;
      for (const auto point : surface_.fv_range(face)) {
        const Place place = places_[std::size_t(point.idx())];
        if (place != Place::on) side = place == Place::whole ? Side::whole : place == Place::above ? Side::above : Side::below;
      }
      cut_.sides.push_back(side ? *side : side_of_flat(surface_.property(source_, face)));
    }
  }

  /// A triangle in the plane bounds a solid that lies behind it, unless its connected part is turned inside out.
  Side side_of_flat(std::uint32_t triangle) {
    if (!parts_) measure_parts();
    const glm::uvec3& t = mesh_.triangles[triangle];
    const glm::dvec3 origin(mesh_.positions[t.x]);
    const bool faces_up = glm::dot(glm::dvec3(plane_), glm::cross(glm::dvec3(mesh_.positions[t.y]) - origin, glm::dvec3(mesh_.positions[t.z]) - origin)) > 0;
    return faces_up == (volumes_[parts_->of_triangle[triangle]] >= 0) ? Side::below : Side::above;
  }

  void measure_parts() {
    parts_ = lumen::connected_parts(mesh_);
    volumes_.assign(parts_->count, 0);
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
      const glm::uvec3& t = mesh_.triangles[i];
      volumes_[parts_->of_triangle[i]] += glm::dot(glm::dvec3(mesh_.positions[t.x]), glm::cross(glm::dvec3(mesh_.positions[t.y]), glm::dvec3(mesh_.positions[t.z])));
    }
  }

  bool lies(HalfEdge half, Side side) const {
    const Face face = surface_.face_handle(half);
    return face.is_valid() && cut_.sides[std::size_t(face.idx())] == side;
  }
  bool is_of_cut(HalfEdge half) const { return lies(half, Side::above) && lies(surface_.opposite_halfedge_handle(half), Side::below); }

  /// The border of what lies above goes on around the end of a half-edge of it; invalid where the mesh ends.
  HalfEdge next_of_cut(HalfEdge half) const {
    for (half = surface_.next_halfedge_handle(half);; half = surface_.next_halfedge_handle(surface_.opposite_halfedge_handle(half))) {
      const HalfEdge beyond = surface_.opposite_halfedge_handle(half);
      if (surface_.is_boundary(beyond)) return HalfEdge();
      if (!lies(beyond, Side::above)) return half;
    }
  }

  void trace_loops() {
    std::vector<bool> seen(surface_.n_halfedges());
    for (const auto first : surface_.halfedges()) {
      if (seen[std::size_t(first.idx())] || !is_of_cut(first)) continue;
      Loop loop{.triangle = std::uint32_t(surface_.face_handle(first).idx())};
      HalfEdge half = first;
      while (half.is_valid() && !seen[std::size_t(half.idx())]) {
        seen[std::size_t(half.idx())] = true;
        loop.points.push_back(number(surface_.from_vertex_handle(half)));
        half = next_of_cut(half);
      }
      if (half == first) cut_.loops.push_back(std::move(loop));
      else cut_.closed = false;
    }
  }

  void gather() {
    cut_.triangles.reserve(surface_.n_faces());
    cut_.sources.reserve(surface_.n_faces());
    for (const auto face : surface_.faces()) {
      const HalfEdge half = surface_.halfedge_handle(face);
      cut_.triangles.emplace_back(number(surface_.from_vertex_handle(half)), number(surface_.to_vertex_handle(half)),
                                  number(surface_.to_vertex_handle(surface_.next_halfedge_handle(half))));
      cut_.sources.push_back(surface_.property(source_, face));
    }
  }

  const lumen::Mesh& mesh_;
  const glm::dvec4 plane_;
  const std::vector<bool>& whole_;
  Surface surface_;
  OpenMesh::FPropHandleT<std::uint32_t> source_;
  std::vector<Place> places_;
  std::optional<lumen::Grouping> parts_;  ///< found when first needed, as `volumes_`
  std::vector<double> volumes_;           ///< of each part, six times, signed
  Cut cut_;
};

}  // namespace

Cut cut(const lumen::Mesh& mesh, const glm::dvec4& plane, const std::vector<bool>& whole, const std::function<void(float)>& progress) {
  // It prints every triangle that it refuses; the filter says so once.
  omerr().disable();
  return Cutter(mesh, plane, whole).run(progress);
}
