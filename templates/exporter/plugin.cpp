/// Points of a surface as text, one per line: x y z.

#include <fstream>

#include <lumen/exporter.h>
#include <lumen/mesh.h>
#include <lumen/temporary_file.h>

namespace {

struct @Class@ : lumen::Exporter {
  using Exporter::Exporter;

  lumen::Input<lumen::Mesh> mesh{this, "mesh", {.doc = "whose points are written"}};

  std::vector<lumen::FileFormat> formats() const override { return {{".@name@", lumen::DataKind::mesh, "points as text"}}; }

  void write(lumen::Job& job) const override {
    const std::string& file = job[path].file;
    const auto source = job[mesh];
    if (!source) throw lumen::Error(file, "there is no mesh to write");
    lumen::TemporaryFile temporary(file);
    std::ofstream text(temporary.path());
    for (const glm::vec3& position : source->positions) text << position.x << ' ' << position.y << ' ' << position.z << '\n';
    text.close();
    if (!text) throw lumen::Error(file, "cannot be written", "is the disk full?");
    temporary.commit();
  }
};

}  // namespace

LUMEN_PLUGIN(@Class@, "exporter.@name@", "Points of a surface as text, one per line.")
