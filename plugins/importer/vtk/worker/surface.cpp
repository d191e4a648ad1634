/// Triangulation, and what goes with the points that stay.
#include "surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <glm/geometric.hpp>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include "arrays.h"
#include "polygon.h"

namespace {

using lumen::Array;
using lumen::Attribute;

/// Triangles of a file's polygons and strips, and which cell each is of.
class Triangulation {
 public:
  explicit Triangulation(const Array<glm::vec3>& points) : points_(points) {
    const auto* numbers = reinterpret_cast<const float*>(points.data());
    float sum = 0;
    for (std::size_t index = 0; index < points.size() * 3; ++index) sum += numbers[index] * 0.0f;
    all_finite_ = sum == 0;
  }

  void add_polygons(vtkCellArray* cells) {
    triangles.reserve(triangles.size() + static_cast<std::size_t>(cells->GetNumberOfCells()));
    cells->Visit([this](auto& state) {
      const auto offsets = vtk::DataArrayValueRange<1>(state.GetOffsets());
      const auto corners = vtk::DataArrayValueRange<1>(state.GetConnectivity());
      for (vtkIdType cell = 0; cell + 1 < offsets.size(); ++cell) {
        const vtkIdType begin = offsets[cell], size = offsets[cell + 1] - begin;
        if (size == 3) {
          add({corners[begin], corners[begin + 1], corners[begin + 2]});
        } else {
          polygon_.clear();
          for (vtkIdType corner = begin; corner < begin + size; ++corner) polygon_.push_back(static_cast<std::uint32_t>(corners[corner]));
          add_polygon();
        }
        ++cell_;
      }
    });
  }

  void add_strips(vtkCellArray* cells) {
    vtkIdType size;
    const vtkIdType* corners;
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell) {
      cells->GetCellAtId(cell, size, corners);
      if (size < 3) ++degenerate;
      for (vtkIdType corner = 0; corner + 2 < size; ++corner) {
        const vtkIdType odd = corner % 2;
        // Strips repeat corners to turn: such triangles are no fault.
        if (const glm::uvec3 triangle(corners[corner], corners[corner + 1 + odd], corners[corner + 2 - odd]); proper(triangle)) add(triangle);
      }
      ++cell_;
    }
  }

  /// The cell of each triangle, to be taken once; empty: each cell is a triangle.
  std::vector<std::uint32_t> take_cells() {
    if (one_to_one_ && triangles.size() != cell_) number_so_far(triangles.size());
    return std::move(cells_);
  }

  std::vector<glm::uvec3> triangles;
  std::size_t degenerate = 0, not_finite = 0;

 private:
  static bool proper(glm::uvec3 triangle) { return triangle.x != triangle.y && triangle.y != triangle.z && triangle.z != triangle.x; }
  bool finite(std::uint32_t point) const {
    const glm::vec3 sum = points_[point] * 0.0f;
    return sum.x + sum.y + sum.z == 0;
  }

  void add(glm::uvec3 triangle) {
    if (!proper(triangle)) {
      ++degenerate;
    } else if (!all_finite_ && !(finite(triangle.x) && finite(triangle.y) && finite(triangle.z))) {
      ++not_finite;
    } else {
      triangles.push_back(triangle);
      number_from(triangles.size() - 1);
    }
  }

  /// The triangles from `first` on are of the cell at hand. As long as each cell is one triangle, numbers would say nothing.
  void number_from(std::size_t first) {
    if (one_to_one_ && first == cell_ && triangles.size() == first + 1) return;
    if (one_to_one_) number_so_far(first);
    cells_.resize(triangles.size(), cell_);
  }

  void number_so_far(std::size_t count) {
    one_to_one_ = false;
    cells_.resize(count);
    std::iota(cells_.begin(), cells_.end(), 0u);
  }

  void add_polygon() {
    polygon_.erase(std::unique(polygon_.begin(), polygon_.end()), polygon_.end());
    while (polygon_.size() > 1 && polygon_.back() == polygon_.front()) polygon_.pop_back();
    if (polygon_.size() < 3) {
      ++degenerate;
    } else if (!all_finite_ && !std::all_of(polygon_.begin(), polygon_.end(), [this](std::uint32_t point) { return finite(point); })) {
      ++not_finite;
    } else {
      const std::size_t before = triangles.size();
      cutter_.cut(points_, polygon_, triangles);
      std::erase_if(triangles, [&, index = std::size_t{0}](glm::uvec3 triangle) mutable { return index++ >= before && !proper(triangle); });
      number_from(before);
    }
  }

  const Array<glm::vec3>& points_;
  bool all_finite_ = true;
  bool one_to_one_ = true;             ///< so far, triangle i is cell i
  std::uint32_t cell_ = 0;
  std::vector<std::uint32_t> cells_;   ///< of each triangle, unless one_to_one_
  std::vector<std::uint32_t> polygon_;
  PolygonCutter cutter_;
};

/// Renumbers the triangles so that they name used points alone. Returns which points those are; empty = all.
std::vector<std::uint32_t> compact(std::vector<glm::uvec3>& triangles, std::size_t points) {
  std::vector<std::uint8_t> used(points);  // bytes: bits would be read and written back, one after the other
  for (const glm::uvec3& triangle : triangles)
    for (int corner = 0; corner < 3; ++corner) used[triangle[corner]] = 1;
  const auto count = static_cast<std::size_t>(std::count(used.begin(), used.end(), 1));
  if (count == points) return {};
  std::vector<std::uint32_t> kept, number(points);
  kept.reserve(count);
  for (std::uint32_t point = 0; point < points; ++point)
    if (used[point]) {
      number[point] = static_cast<std::uint32_t>(kept.size());
      kept.push_back(point);
    }
  for (glm::uvec3& triangle : triangles) triangle = {number[triangle.x], number[triangle.y], number[triangle.z]};
  return kept;
}

/// As unit vectors; empty if one is not finite.
Array<glm::vec3> unit(const Array<glm::vec3>& normals) {
  bool are_unit = true;
  for (const glm::vec3& normal : normals) {
    const float square = glm::dot(normal, normal);
    if (!std::isfinite(square)) return {};
    are_unit = are_unit && std::abs(square - 1) < 1e-3f;
  }
  if (are_unit) return normals;
  std::vector<glm::vec3> result(normals.begin(), normals.end());
  for (glm::vec3& normal : result) {
    const float length = glm::length(normal);
    normal = length > 0 ? normal / length : glm::vec3(0);
  }
  return result;
}

Array<glm::vec2> texture_coordinates_of(const Array<float>& values, int components) {
  std::vector<glm::vec2> result(values.size() / static_cast<std::size_t>(components));
  for (std::size_t point = 0; point < result.size(); ++point) {
    const float* tuple = values.data() + point * static_cast<std::size_t>(components);
    result[point] = {tuple[0], components > 1 ? tuple[1] : 0.0f};
    if (!std::isfinite(result[point].x) || !std::isfinite(result[point].y)) return {};
  }
  return result;
}

Array<glm::vec3> points_of(vtkPolyData* data) { return tuples_of<glm::vec3>(floats_of(data->GetPoints()->GetData())); }

void check_count(const std::string& file, vtkPolyData* data) {
  constexpr auto most = static_cast<vtkIdType>(std::numeric_limits<std::uint32_t>::max());
  if (data->GetNumberOfPoints() > most || data->GetNumberOfCells() > most)
    throw lumen::Error(file, "holds more points or cells than 32-bit numbers count");
}

void note(lumen::WorkerReply& reply, std::size_t count, const char* what) {
  if (count) reply.notes.push_back({lumen::Severity::warning, lumen::grouped(count) + " " + what});
}

}  // namespace

std::shared_ptr<lumen::Mesh> mesh_of(vtkPolyData* data, const std::string& file, lumen::WorkerReply& reply) {
  check_count(file, data);
  const auto points = static_cast<std::size_t>(data->GetNumberOfPoints());
  const vtkIdType first_cell = data->GetNumberOfVerts() + data->GetNumberOfLines();
  const vtkIdType cells = data->GetNumberOfPolys() + data->GetNumberOfStrips();
  if (cells == 0) return nullptr;

  const Array<glm::vec3> positions = points_of(data);
  Triangulation triangulation(positions);
  triangulation.add_polygons(data->GetPolys());
  triangulation.add_strips(data->GetStrips());
  note(reply, triangulation.degenerate, "degenerate cells skipped");
  note(reply, triangulation.not_finite, "cells skipped: a point of theirs is not finite");
  if (triangulation.triangles.empty()) return nullptr;

  auto mesh = std::make_shared<lumen::Mesh>();
  mesh->origin = file;
  const std::vector<std::uint32_t> kept = compact(triangulation.triangles, points);
  const auto of_kept = [&](const Array<float>& values, int components) { return kept.empty() ? values : gathered(values, components, kept); };
  mesh->positions = kept.empty() ? positions : tuples_of<glm::vec3>(gathered({{&positions.data()->x, points * 3}, nullptr}, 3, kept));

  vtkPointData* point_data = data->GetPointData();
  vtkDataArray* normals = point_data->GetNormals();
  vtkDataArray* coordinates = point_data->GetTCoords();
  const auto fits = [&](vtkDataArray* array, int least, int most) {
    return array && array->GetNumberOfTuples() == data->GetNumberOfPoints() && array->GetNumberOfComponents() >= least && array->GetNumberOfComponents() <= most;
  };
  if (!fits(normals, 3, 3)) normals = nullptr;
  if (!fits(coordinates, 1, 3)) coordinates = nullptr;
  if (normals) mesh->normals = unit(tuples_of<glm::vec3>(of_kept(floats_of(normals), 3)));
  if (mesh->normals.empty()) mesh->normals = lumen::average_normals(mesh->positions, triangulation.triangles);
  if (coordinates) {
    const int components = coordinates->GetNumberOfComponents();
    mesh->texture_coordinates = texture_coordinates_of(of_kept(floats_of(coordinates), components), components);
  }

  mesh->attributes = attributes_of(point_data, Attribute::On::points, data->GetNumberOfPoints(), {normals, coordinates}, reply);
  for (Attribute& attribute : mesh->attributes) attribute.values = of_kept(attribute.values, attribute.components);
  for (Attribute& attribute : attributes_of(data->GetCellData(), Attribute::On::cells, data->GetNumberOfCells(), {}, reply)) {
    const auto components = static_cast<std::size_t>(attribute.components);
    attribute.values = part_of(attribute.values, static_cast<std::size_t>(first_cell) * components, static_cast<std::size_t>(cells) * components);
    mesh->attributes.push_back(std::move(attribute));
  }
  mesh->triangle_cells = triangulation.take_cells();
  mesh->triangles = std::move(triangulation.triangles);
  mesh->finish();
  return mesh;
}

std::shared_ptr<lumen::Lines> lines_of(vtkPolyData* data, const std::string& file, lumen::WorkerReply& reply) {
  check_count(file, data);
  if (data->GetNumberOfLines() == 0) return nullptr;
  const Array<glm::vec3> points = points_of(data);
  const auto finite = [&](vtkIdType point) {
    const glm::vec3 position = points[static_cast<std::size_t>(point)] * 0.0f;
    return position.x + position.y + position.z == 0;
  };

  std::vector<std::uint32_t> sources, offsets{0}, kept_lines;
  std::size_t too_short = 0, not_finite = 0;
  vtkIdType size;
  const vtkIdType* corners;
  for (vtkIdType line = 0; line < data->GetNumberOfLines(); ++line) {
    data->GetLines()->GetCellAtId(line, size, corners);
    if (size < 2) {
      ++too_short;
    } else if (!std::all_of(corners, corners + size, finite)) {
      ++not_finite;
    } else {
      sources.insert(sources.end(), corners, corners + size);
      offsets.push_back(static_cast<std::uint32_t>(sources.size()));
      kept_lines.push_back(static_cast<std::uint32_t>(line + data->GetNumberOfVerts()));
    }
  }
  note(reply, too_short, "lines of fewer than two points skipped");
  note(reply, not_finite, "lines skipped: a point of theirs is not finite");
  if (kept_lines.empty()) return nullptr;

  auto lines = std::make_shared<lumen::Lines>();
  lines->origin = file;
  lines->positions = tuples_of<glm::vec3>(gathered({{&points.data()->x, points.size() * 3}, nullptr}, 3, sources));
  lines->offsets = std::move(offsets);
  lines->attributes = attributes_of(data->GetPointData(), Attribute::On::points, data->GetNumberOfPoints(), {}, reply);
  for (Attribute& attribute : lines->attributes) attribute.values = gathered(attribute.values, attribute.components, sources);
  for (Attribute& attribute : attributes_of(data->GetCellData(), Attribute::On::cells, data->GetNumberOfCells(), {}, reply)) {
    attribute.values = gathered(attribute.values, attribute.components, kept_lines);
    lines->attributes.push_back(std::move(attribute));
  }
  lines->finish();
  return lines;
}
