/// Meshes and lines into files, written by VTK in a process of its own.
#include <algorithm>
#include <cctype>
#include <filesystem>

#include <lumen/exporter.h>
#include <lumen/lines.h>
#include <lumen/mesh.h>
#include <lumen/temporary_file.h>

namespace {

struct VtkExporter : lumen::Exporter {
  using Exporter::Exporter;
  lumen::Input<lumen::Mesh> mesh{this, "mesh", {.doc = "the surface to write, with its arrays"}};
  lumen::Input<lumen::Lines> lines{this, "lines", {.doc = "the polylines to write, if no mesh is linked"}};

  std::vector<lumen::FileFormat> formats() const override {
    using lumen::DataKind;
    return {{".vtp", DataKind::mesh, "VTK XML polygons"},  {".vtp", DataKind::lines, "VTK XML polygons"},
            {".vtk", DataKind::mesh, "VTK legacy"},        {".vtk", DataKind::lines, "VTK legacy"},
            {".stl", DataKind::mesh, "Stereolithography"}, {".obj", DataKind::mesh, "Wavefront OBJ"},
            {".ply", DataKind::mesh, "Polygon file format"}};
  }

  void write(lumen::Job& job) const override {
    const std::string& file = job[path].file;
    if (file.empty()) throw lumen::Error("exporter.vtk", "no file to write to", "set path");
    lumen::DataPointer data = job[mesh];
    if (!data) data = job[lines];
    if (!data) throw lumen::Error(file, "there is no mesh and no lines to write");

    std::string extension = std::filesystem::path(file).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char letter) { return std::tolower(letter); });
    const auto formats = this->formats();
    const bool known = std::any_of(formats.begin(), formats.end(), [&](const lumen::FileFormat& format) {
      return format.extension == extension && format.data == data->kind();
    });
    if (!known)
      throw lumen::Error(file, "no format for '" + extension + "'",
                         data->kind() == lumen::DataKind::mesh ? "a mesh becomes .vtp .vtk .stl .obj or .ply" : "lines become .vtp or .vtk");
    lumen::TemporaryFile temporary(file);
    job.run({"vtk", "write", {{"path", temporary.path()}, {"format", extension}}, {data}});
    temporary.commit();
  }
};
LUMEN_PLUGIN(VtkExporter, "exporter.vtk", "writes meshes and lines as .vtp .vtk, meshes as .stl .obj .ply too")

}  // namespace
