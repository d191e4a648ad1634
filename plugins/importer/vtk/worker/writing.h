/// Mesh and Lines through VTK's writers.
#pragma once

#include <lumen/worker.h>

/// Arguments: path; format ".vtp" ".vtk" ".stl" ".obj" ".ply". One input: a mesh, or (first two formats) lines. Throws lumen::Error.
void write_file(const lumen::WorkerRequest& request, lumen::WorkerProgress progress);
