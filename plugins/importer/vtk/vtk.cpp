/// Surfaces and polylines from files, read by VTK in a process of its own.
#include <lumen/importer.h>
#include <lumen/lines.h>
#include <lumen/mesh.h>

namespace {

struct VtkImporter : lumen::Importer {
  using Importer::Importer;
  lumen::Property<lumen::Path> path{this, "path", {}, {.doc = "the file to read"}};
  lumen::Output<lumen::Mesh> mesh{this, "mesh", {.doc = "the surface, triangulated, with its point and cell arrays"}};
  lumen::Output<lumen::Lines> lines{this, "lines", {.doc = "the polylines"}};

  std::vector<lumen::FileFormat> formats() const override {
    using lumen::DataKind;
    return {{".vtp", DataKind::mesh, "VTK XML polygons"}, {".vtu", DataKind::mesh, "VTK XML unstructured grid"},
            {".vtk", DataKind::mesh, "VTK legacy"},       {".stl", DataKind::mesh, "Stereolithography"},
            {".obj", DataKind::mesh, "Wavefront OBJ"},    {".ply", DataKind::mesh, "Polygon file format"}};
  }

  void compute(lumen::Job& job) const override {
    const std::string& file = job[path].file;
    if (file.empty()) return;
    const lumen::WorkerReply reply = job.run({"vtk", "read", {{"path", file}}, {}, file});
    for (const lumen::DataPointer& data : reply.data) {
      if (auto surface = std::dynamic_pointer_cast<const lumen::Mesh>(data)) job.set(mesh, surface);
      if (auto curves = std::dynamic_pointer_cast<const lumen::Lines>(data)) job.set(lines, curves);
    }
  }
};
LUMEN_PLUGIN(VtkImporter, "importer.vtk", "surfaces and polylines from .vtp .vtu .vtk .stl .obj .ply files")

}  // namespace
