/// From a file's own indices per corner to one index per point.
#include "obj.h"

#include <algorithm>
#include <utility>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include "obj_text.h"

namespace {

constexpr std::uint32_t none = ~0u;

/// One point per combination of indices that a corner uses.
class Welder {
 public:
  explicit Welder(const ObjText& text) : text_(text), points_(text.positions.size()) {
    for (std::uint32_t point = 0; point < points_.size(); ++point) points_[point].position = point;
  }

  bool names_what_is_there(const ObjCorner& corner) const {
    return corner.position >= 0 && corner.position < static_cast<std::int64_t>(text_.positions.size());
  }

  std::uint32_t point_of(const ObjCorner& corner) {
    const std::uint32_t coordinate = valid(corner.coordinate, text_.coordinates.size()), normal = valid(corner.normal, text_.normals.size());
    all_have_normals = all_have_normals && normal != none;
    any_has_coordinates = any_has_coordinates || coordinate != none;
    auto index = static_cast<std::uint32_t>(corner.position);
    // Where very many corners meet, a search to the end would take forever: then some points stay doubled.
    constexpr int longest_search = 64;
    for (int step = 0;; ++step) {
      Point& point = points_[index];
      if (!point.used) {
        point.used = true;
        point.coordinate = coordinate;
        point.normal = normal;
      }
      if (point.coordinate == coordinate && point.normal == normal) return index;
      if (point.next == none || step == longest_search) break;
      index = point.next;
    }
    const auto added = static_cast<std::uint32_t>(points_.size());
    const std::uint32_t next = std::exchange(points_[index].next, added);
    points_.push_back({static_cast<std::uint32_t>(corner.position), coordinate, normal, next, true});
    return added;
  }

  template <class T> vtkSmartPointer<vtkFloatArray> gathered(const char* name, const std::vector<T>& values, std::uint32_t (*index_of)(const Welder&, std::size_t)) const {
    vtkNew<vtkFloatArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(sizeof(T) / sizeof(float));
    array->SetNumberOfTuples(static_cast<vtkIdType>(points_.size()));
    auto* target = reinterpret_cast<T*>(array->GetPointer(0));
    for (std::size_t point = 0; point < points_.size(); ++point) {
      const std::uint32_t index = index_of(*this, point);
      target[point] = index == none ? T(0) : values[index];
    }
    return array.Get();
  }
  static std::uint32_t position(const Welder& self, std::size_t point) { return self.points_[point].position; }
  static std::uint32_t coordinate(const Welder& self, std::size_t point) { return self.points_[point].coordinate; }
  static std::uint32_t normal(const Welder& self, std::size_t point) { return self.points_[point].normal; }

  bool all_have_normals = true, any_has_coordinates = false;

 private:
  struct Point {
    std::uint32_t position = 0, coordinate = none, normal = none;
    std::uint32_t next = none;   ///< another point at the same position
    bool used = false;
  };
  static std::uint32_t valid(std::int64_t index, std::size_t count) {
    return index >= 0 && index < static_cast<std::int64_t>(count) ? static_cast<std::uint32_t>(index) : none;
  }

  const ObjText& text_;
  std::vector<Point> points_;
};

/// Appends groups and materials of the cells that could be made.
vtkSmartPointer<vtkCellArray> cells_of(const ObjText::Cells& cells, Welder& welder, vtkFloatArray* groups, vtkFloatArray* materials, std::size_t& dangling) {
  vtkNew<vtkTypeInt32Array> offsets, corners;
  offsets->Allocate(static_cast<vtkIdType>(cells.offsets.size()));
  corners->Allocate(static_cast<vtkIdType>(cells.corners.size()));
  offsets->InsertNextValue(0);
  for (std::size_t cell = 0; cell + 1 < cells.offsets.size(); ++cell) {
    const auto begin = cells.corners.begin() + cells.offsets[cell], end = cells.corners.begin() + cells.offsets[cell + 1];
    if (!std::all_of(begin, end, [&](const ObjCorner& corner) { return welder.names_what_is_there(corner); })) {
      ++dangling;
      continue;
    }
    for (auto corner = begin; corner != end; ++corner) corners->InsertNextValue(static_cast<std::int32_t>(welder.point_of(*corner)));
    offsets->InsertNextValue(static_cast<std::int32_t>(corners->GetNumberOfValues()));
    groups->InsertNextValue(cells.groups[cell]);
    materials->InsertNextValue(cells.materials[cell]);
  }
  vtkNew<vtkCellArray> result;
  result->SetData(offsets, corners);
  return result.Get();
}

}  // namespace

vtkSmartPointer<vtkPolyData> read_obj(const std::string& path, lumen::WorkerReply& reply, lumen::WorkerProgress progress) {
  const ObjText text = parse_obj(path, progress);
  Welder welder(text);
  vtkNew<vtkFloatArray> groups, materials;
  groups->SetName("GroupIds");
  materials->SetName("MaterialIds");
  std::size_t dangling = 0;
  vtkNew<vtkPolyData> data;
  // The order of cell arrays: lines before polygons.
  data->SetLines(cells_of(text.lines, welder, groups, materials, dangling));
  data->SetPolys(cells_of(text.polygons, welder, groups, materials, dangling));
  data->GetCellData()->AddArray(groups);
  data->GetCellData()->AddArray(materials);

  vtkNew<vtkPoints> points;
  points->SetData(welder.gathered("Points", text.positions, Welder::position));
  data->SetPoints(points);
  if (!text.normals.empty() && welder.all_have_normals) data->GetPointData()->SetNormals(welder.gathered("Normals", text.normals, Welder::normal));
  if (welder.any_has_coordinates) data->GetPointData()->SetTCoords(welder.gathered("TextureCoordinates", text.coordinates, Welder::coordinate));
  if (!text.colors.empty() && text.colors.size() == text.positions.size()) data->GetPointData()->AddArray(welder.gathered("RGB", text.colors, Welder::position));

  const auto note = [&](std::size_t count, const char* what) {
    if (count) reply.notes.push_back({lumen::Severity::warning, lumen::grouped(count) + " " + what});
  };
  note(dangling, "cells skipped: they name points that are not there");
  note(text.ill_formed, "cells skipped: their corners are no numbers");
  return data.Get();
}
