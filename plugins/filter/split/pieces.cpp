#include "pieces.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <lumen/error.h>

namespace {

constexpr std::uint32_t unused = 0xffffffffu;
constexpr const char* cap_array = "cap";

}  // namespace

Pieces::Pieces(const lumen::Mesh& mesh, const Cut& cut, const Caps& caps, bool doubled) : mesh_(mesh), cut_(cut), caps_(caps), doubled_(doubled) {
  capped_.resize(mesh.positions.size() + cut.added.size());
  for (const glm::uvec3& t : caps.triangles)
    for (int corner = 0; corner < 3; ++corner) capped_[t[corner]] = true;
  make_cells();
}

/// Each face of the caps is a cell after those of the mesh: the array "cap" is 1 there, other arrays have the value of a cell beside it.
void Pieces::make_cells() {
  const auto cell_of = [&](std::uint32_t triangle) { return mesh_.triangle_cells.empty() ? triangle : mesh_.triangle_cells[triangle]; };
  constexpr std::uint32_t most_cells = 1u << 28;
  for (std::uint32_t triangle = 0; triangle < mesh_.triangles.size(); ++triangle) {
    if (cell_of(triangle) >= most_cells) throw lumen::Error("'" + mesh_.origin + "'", "it has a cell of the number " + lumen::grouped(cell_of(triangle)), "cells beyond 268,435,456 cannot be split");
    cells_ = std::max(cells_, cell_of(triangle) + 1);
  }
  const auto on_cells = [](const lumen::Attribute& array) { return array.on == lumen::Attribute::On::cells; };
  for (const lumen::Attribute& array : mesh_.attributes)
    if (on_cells(array)) cells_ = std::max(cells_, std::uint32_t(array.values.size() / std::size_t(array.components)));
  for (const lumen::Attribute& array : mesh_.attributes)
    if (on_cells(array)) cell_arrays_.push_back(array);
  if (caps_.beside.empty()) return;
  if (std::none_of(cell_arrays_.begin(), cell_arrays_.end(), [](const lumen::Attribute& array) { return array.name == cap_array; }))
    cell_arrays_.push_back({cap_array, lumen::Attribute::On::cells, 1, std::vector<float>(cells_)});
  for (lumen::Attribute& array : cell_arrays_) {
    const auto components = std::size_t(array.components);
    std::vector<float> values(array.values.begin(), array.values.end());
    values.resize(cells_ * components);
    const bool marks = array.name == cap_array && components == 1;
    for (const std::uint32_t beside : caps_.beside)
      for (std::size_t i = 0; i < components; ++i) values.push_back(marks ? 1 : values[cell_of(cut_.sources[beside]) * components + i]);
    array.values = std::move(values);
  }
}

class Pieces::Builder {
 public:
  explicit Builder(const Pieces& pieces) : pieces_(pieces), surface_numbers_(pieces.capped_.size()), cap_numbers_(pieces.doubled_ ? pieces.capped_.size() : 0) {}

  void add(const Piece& piece) {
    const Cut& cut = pieces_.cut_;
    const Caps& caps = pieces_.caps_;
    move_ = piece.move;
    std::fill(surface_numbers_.begin(), surface_numbers_.end(), unused);
    std::fill(cap_numbers_.begin(), cap_numbers_.end(), unused);
    for (std::size_t i = 0; i < cut.triangles.size(); ++i) {
      if (cut.sides[i] != piece.side) continue;
      const std::uint32_t source = cut.sources[i];
      add(cut.triangles[i], pieces_.mesh_.triangle_cells.empty() ? source : pieces_.mesh_.triangle_cells[source], surface_numbers_, !pieces_.doubled_);
    }
    if (piece.side == Side::whole) return;
    for (std::size_t i = 0; i < caps.triangles.size(); ++i) {
      glm::uvec3 corners = caps.triangles[i];
      if (piece.side == Side::above) std::swap(corners.y, corners.z);
      add(corners, pieces_.cells_ + caps.faces[i], pieces_.doubled_ ? cap_numbers_ : surface_numbers_, true);
    }
  }

  std::vector<Point> points;
  std::vector<glm::uvec3> triangles;
  std::vector<std::uint32_t> cells;

 private:
  void add(const glm::uvec3& corners, std::uint32_t cell, std::vector<std::uint32_t>& numbers, bool flat_rim) {
    glm::uvec3 triangle;
    for (int corner = 0; corner < 3; ++corner) {
      const std::uint32_t point = corners[corner];
      if (numbers[point] == unused) {
        numbers[point] = std::uint32_t(points.size());
        points.push_back({pieces_.cut_.origin(point, pieces_.mesh_.positions.size()), move_, flat_rim && pieces_.capped_[point]});
      }
      triangle[corner] = numbers[point];
    }
    triangles.push_back(triangle);
    cells.push_back(cell);
  }

  const Pieces& pieces_;
  glm::vec3 move_{0};
  std::vector<std::uint32_t> surface_numbers_, cap_numbers_;  ///< of the cut's points in the mesh that is being made
};

std::vector<float> Pieces::values_of(std::span<const Point> points, const lumen::Attribute& attribute) const {
  const auto components = std::size_t(attribute.components);
  std::vector<float> values;
  values.reserve(points.size() * components);
  for (const Point& point : points) {
    const float *from = attribute.values.data() + point.origin.from * components, *to = attribute.values.data() + point.origin.to * components;
    for (std::size_t i = 0; i < components; ++i) values.push_back(point.origin.from == point.origin.to ? from[i] : glm::mix(from[i], to[i], point.origin.share));
  }
  return values;
}

std::shared_ptr<lumen::Mesh> Pieces::joined(const std::vector<Piece>& pieces, const std::string& origin) const {
  Builder builder(*this);
  for (const Piece& piece : pieces) builder.add(piece);

  auto result = std::make_shared<lumen::Mesh>();
  result->origin = origin;
  const auto mixed = [&](const auto& values, const Point& point) {
    const auto &from = values[point.origin.from], &to = values[point.origin.to];
    return point.origin.from == point.origin.to ? from : from + (to - from) * point.origin.share;
  };
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::vec2> texture_coordinates;
  positions.reserve(builder.points.size());
  for (const Point& point : builder.points) positions.push_back(mixed(mesh_.positions, point) + point.move);
  if (!mesh_.normals.empty()) {
    normals.reserve(builder.points.size());
    for (const Point& point : builder.points) {
      const glm::vec3 normal = point.flat ? glm::vec3(0) : mixed(mesh_.normals, point);
      const float length = glm::length(normal);
      normals.push_back(length > 0 ? normal / length : glm::vec3(0));
    }
  }
  if (!mesh_.texture_coordinates.empty()) {
    texture_coordinates.reserve(builder.points.size());
    for (const Point& point : builder.points) texture_coordinates.push_back(mixed(mesh_.texture_coordinates, point));
  }
  for (const lumen::Attribute& array : mesh_.attributes)
    if (array.on == lumen::Attribute::On::points) result->attributes.push_back({array.name, array.on, array.components, values_of(builder.points, array)});
  // A mesh without triangles has no cells that could be numbered.
  if (!builder.triangles.empty()) result->attributes.insert(result->attributes.end(), cell_arrays_.begin(), cell_arrays_.end());
  result->positions = std::move(positions);
  result->normals = std::move(normals);
  result->texture_coordinates = std::move(texture_coordinates);
  result->triangles = std::move(builder.triangles);
  result->triangle_cells = std::move(builder.cells);
  result->finish();
  return result;
}
