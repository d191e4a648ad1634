/// vtkPolyData becomes Mesh and Lines.
#pragma once

#include <memory>
#include <string>

#include <vtkPolyData.h>

#include <lumen/lines.h>
#include <lumen/mesh.h>
#include <lumen/worker.h>

/// The polygons and strips as triangles. Null if there are none. Degenerate cells and such with points that are not finite
/// are left out with a note; points that no triangle uses go.
std::shared_ptr<lumen::Mesh> mesh_of(vtkPolyData* data, const std::string& file, lumen::WorkerReply& reply);

/// The polylines of two points or more. Null if there are none.
std::shared_ptr<lumen::Lines> lines_of(vtkPolyData* data, const std::string& file, lumen::WorkerReply& reply);
