/// Files through VTK's readers.
#pragma once

#include <string>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <lumen/worker.h>

#include "file_kind.h"

/// The surface and lines of a file; what has no surface of its own (grids) gives its boundary. Checked so far that no cell
/// names a point that is not there. Throws lumen::Error; notes go to the reply.
vtkSmartPointer<vtkPolyData> read_file(const std::string& path, FileKind kind, lumen::WorkerReply& reply, lumen::WorkerProgress progress);
