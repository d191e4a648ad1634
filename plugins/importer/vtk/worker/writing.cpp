/// Wraps our arrays as VTK's without a copy, and writes them.
#include "writing.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArrayRange.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkOBJWriter.h>
#include <vtkPLYWriter.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkSTLWriter.h>
#include <vtkXMLPolyDataWriter.h>

#include <lumen/lines.h>
#include <lumen/mesh.h>

#include "file_kind.h"
#include "messages.h"

namespace {

/// VTK sees the memory of `values`, which must outlive it.
vtkNew<vtkFloatArray> borrowed(const float* values, std::size_t count, int components, const std::string& name) {
  vtkNew<vtkFloatArray> array;
  array->SetNumberOfComponents(components);
  constexpr int keep = 1;
  array->SetArray(const_cast<float*>(values), static_cast<vtkIdType>(count), keep);
  if (!name.empty()) array->SetName(name.c_str());
  return array;
}

void set_points(vtkPolyData* data, const lumen::Array<glm::vec3>& positions) {
  vtkNew<vtkPoints> points;
  points->SetData(borrowed(&positions.data()->x, positions.size() * 3, 3, "Points"));
  data->SetPoints(points);
}

/// `tuple_of` gives the source tuple of each written cell; empty = its own number.
void add_attributes(vtkPolyData* data, const std::vector<lumen::Attribute>& attributes, const lumen::Array<std::uint32_t>& tuple_of) {
  for (const lumen::Attribute& attribute : attributes) {
    const auto& values = attribute.values;
    if (attribute.on == lumen::Attribute::On::points) {
      data->GetPointData()->AddArray(borrowed(values.data(), values.size(), attribute.components, attribute.name));
    } else if (tuple_of.empty()) {
      data->GetCellData()->AddArray(borrowed(values.data(), values.size(), attribute.components, attribute.name));
    } else {
      vtkNew<vtkFloatArray> array;
      array->SetName(attribute.name.c_str());
      array->SetNumberOfComponents(attribute.components);
      array->SetNumberOfTuples(static_cast<vtkIdType>(tuple_of.size()));
      for (std::size_t cell = 0; cell < tuple_of.size(); ++cell)
        array->SetTypedTuple(static_cast<vtkIdType>(cell), values.data() + std::size_t{tuple_of[cell]} * static_cast<std::size_t>(attribute.components));
      data->GetCellData()->AddArray(array);
    }
  }
}

void fill(vtkPolyData* data, const lumen::Mesh& mesh) {
  set_points(data, mesh.positions);
  vtkNew<vtkTypeInt32Array> corners;
  corners->SetNumberOfValues(static_cast<vtkIdType>(mesh.triangles.size() * 3));
  const std::uint32_t* indices = &mesh.triangles.data()->x;
  std::copy(indices, indices + mesh.triangles.size() * 3, corners->GetPointer(0));
  vtkNew<vtkCellArray> cells;
  cells->SetData(3, corners);
  data->SetPolys(cells);
  if (!mesh.normals.empty()) data->GetPointData()->SetNormals(borrowed(&mesh.normals.data()->x, mesh.normals.size() * 3, 3, "Normals"));
  if (!mesh.texture_coordinates.empty())
    data->GetPointData()->SetTCoords(borrowed(&mesh.texture_coordinates.data()->x, mesh.texture_coordinates.size() * 2, 2, "TextureCoordinates"));
  add_attributes(data, mesh.attributes, mesh.triangle_cells);
}

void fill(vtkPolyData* data, const lumen::Lines& lines) {
  set_points(data, lines.positions);
  vtkNew<vtkTypeInt64Array> offsets, corners;
  offsets->SetNumberOfValues(static_cast<vtkIdType>(lines.offsets.size()));
  std::copy(lines.offsets.begin(), lines.offsets.end(), offsets->GetPointer(0));
  corners->SetNumberOfValues(static_cast<vtkIdType>(lines.positions.size()));
  for (vtkIdType point = 0; point < corners->GetNumberOfValues(); ++point) corners->SetValue(point, point);
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, corners);
  data->SetLines(cells);
  add_attributes(data, lines.attributes, {});
}

template <class Writer> bool write(Writer* writer, vtkPolyData* data, const std::string& path) {
  writer->SetFileName(path.c_str());
  writer->SetInputData(data);
  return writer->Write() != 0;
}

bool write_as(const std::string& format, vtkPolyData* data, const std::string& path) {
  if (format == ".vtp") {
    vtkNew<vtkXMLPolyDataWriter> writer;
    // Raw and uncompressed: written and read at the speed of the disk.
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    writer->SetCompressorTypeToNone();
    return write(writer.Get(), data, path);
  }
  if (format == ".vtk") {
    vtkNew<vtkPolyDataWriter> writer;
    writer->SetFileTypeToBinary();
    return write(writer.Get(), data, path);
  }
  if (format == ".stl") {
    vtkNew<vtkSTLWriter> writer;
    writer->SetFileTypeToBinary();
    return write(writer.Get(), data, path);
  }
  if (format == ".obj") {
    vtkNew<vtkOBJWriter> writer;
    return write(writer.Get(), data, path);
  }
  if (format == ".ply") {
    vtkNew<vtkPLYWriter> writer;
    writer->SetFileTypeToBinary();
    return write(writer.Get(), data, path);
  }
  throw lumen::Error(short_name(path), "no format for '" + format + "'", ".vtp .vtk .stl .obj .ply can be written");
}

}  // namespace

void write_file(const lumen::WorkerRequest& request, lumen::WorkerProgress progress) {
  const std::string& path = request.arguments.at("path");
  const std::string& format = request.arguments.at("format");
  Messages messages;
  vtkNew<vtkPolyData> data;
  const auto* input = request.inputs.empty() ? nullptr : request.inputs.front().get();
  if (const auto* mesh = dynamic_cast<const lumen::Mesh*>(input)) fill(data, *mesh);
  else if (const auto* lines = dynamic_cast<const lumen::Lines*>(input)) fill(data, *lines);
  else throw lumen::Error(short_name(path), "there is no mesh and no lines to write");
  progress(0.1f);
  const bool written = write_as(format, data, path);
  if (const std::string message = messages.first(short_name(path)); !message.empty()) throw lumen::Error(message);
  if (!written) throw lumen::Error(short_name(path), "could not be written", "check the folder and the space on the disk");
}
