/// One reader per kind of file, and the boundary of grids.
#include "reading.h"

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataSet.h>
#include <vtkGenericDataObjectReader.h>
#include <vtkGeometryFilter.h>
#include <vtkNew.h>
#include <vtkPLYReader.h>
#include <vtkPointSet.h>
#include <vtkSTLReader.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include "messages.h"
#include "obj.h"

namespace {

using Pointer = vtkSmartPointer<vtkAlgorithm>;

template <class Reader> Pointer named(const std::string& path) {
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  return reader.Get();
}

Pointer reader_of(const std::string& path, FileKind kind) {
  switch (kind) {
    case FileKind::xml_polygons: return named<vtkXMLPolyDataReader>(path);
    case FileKind::xml_unstructured: return named<vtkXMLUnstructuredGridReader>(path);
    case FileKind::stl: return named<vtkSTLReader>(path);
    case FileKind::ply: return named<vtkPLYReader>(path);
    case FileKind::obj: case FileKind::legacy: break;
  }
  vtkNew<vtkGenericDataObjectReader> reader;
  reader->SetFileName(path.c_str());
  // Without these a legacy file keeps only the first array of each kind.
  reader->ReadAllScalarsOn();
  reader->ReadAllVectorsOn();
  reader->ReadAllNormalsOn();
  reader->ReadAllTensorsOn();
  reader->ReadAllColorScalarsOn();
  reader->ReadAllTCoordsOn();
  reader->ReadAllFieldsOn();
  return reader.Get();
}

void forward_progress(vtkObject* caller, unsigned long, void* client, void*) {
  const auto progress = reinterpret_cast<lumen::WorkerProgress>(client);
  progress(0.8f * static_cast<float>(static_cast<vtkAlgorithm*>(caller)->GetProgress()));
}

bool valid(vtkCellArray* cells, vtkIdType points) {
  if (!cells || cells->GetNumberOfCells() == 0) return true;
  if (!cells->IsValid()) return false;
  return cells->Visit([points](auto& state) {
    // As unsigned, a negative index is large.
    std::uint64_t largest = 0;
    for (const auto index : vtk::DataArrayValueRange<1>(state.GetConnectivity())) largest = std::max(largest, static_cast<std::uint64_t>(index));
    return state.GetConnectivity()->GetNumberOfValues() == 0 || largest < static_cast<std::uint64_t>(points);
  });
}

/// VTK's filters trust the connectivity of what they are given.
void check_cells(const std::string& file, vtkDataSet* data) {
  const vtkIdType points = data->GetNumberOfPoints();
  bool good = true;
  if (auto* polygons = vtkPolyData::SafeDownCast(data))
    good = valid(polygons->GetVerts(), points) && valid(polygons->GetLines(), points) && valid(polygons->GetPolys(), points) && valid(polygons->GetStrips(), points);
  else if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
    good = valid(grid->GetCells(), points);
  if (!good) throw lumen::Error(file, "its cells name points that are not there");
}

}  // namespace

vtkSmartPointer<vtkPolyData> read_file(const std::string& path, FileKind kind, lumen::WorkerReply& reply, lumen::WorkerProgress progress) {
  const std::string file = short_name(path);
  if (kind == FileKind::obj) {
    vtkSmartPointer<vtkPolyData> surface = read_obj(path, reply, progress);
    if (surface->GetNumberOfPoints() == 0) throw lumen::Error(file, "holds no points");
    return surface;
  }
  Messages messages;
  const Pointer reader = reader_of(path, kind);
  vtkNew<vtkCallbackCommand> observer;
  observer->SetCallback(forward_progress);
  observer->SetClientData(reinterpret_cast<void*>(progress));
  reader->AddObserver(vtkCommand::ProgressEvent, observer);
  reader->Update();

  vtkDataObject* output = reader->GetOutputDataObject(0);
  auto* data = vtkDataSet::SafeDownCast(output);
  if (!data || data->GetNumberOfPoints() == 0) {
    if (const std::string message = messages.first(file); !message.empty()) throw lumen::Error(message);
    if (output && !data) throw lumen::Error(file, std::string("holds a ") + output->GetClassName() + ", which has no surface");
    throw lumen::Error(file, "holds no points");
  }
  check_cells(file, data);

  vtkSmartPointer<vtkPolyData> surface = vtkPolyData::SafeDownCast(data);
  if (!surface) {
    vtkNew<vtkGeometryFilter> boundary;
    boundary->SetInputData(data);
    boundary->Update();
    surface = boundary->GetOutput();
    check_cells(file, surface);
  }
  if (messages.failed() && surface->GetNumberOfCells() == 0) throw lumen::Error(messages.first(file));
  if (const std::string message = messages.first(file); !message.empty()) reply.notes.push_back({lumen::Severity::warning, message});
  return surface;
}
