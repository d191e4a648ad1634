/// Wavefront OBJ files: ours, as VTK's reader crashes on some and takes ten times as long.
#pragma once

#include <string>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <lumen/worker.h>

/// Points are doubled where a corner has another normal or texture coordinate. Cells that name what is not there are left
/// out with a note. Cell arrays GroupIds and MaterialIds, point array RGB if all points have colors. Throws lumen::Error.
vtkSmartPointer<vtkPolyData> read_obj(const std::string& path, lumen::WorkerReply& reply, lumen::WorkerProgress progress);
