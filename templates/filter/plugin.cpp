/// Moves each point of a surface along its normal.

#include <lumen/filter.h>
#include <lumen/mesh.h>

namespace {

struct @Class@ : lumen::Filter {
  using Filter::Filter;

  lumen::Input<lumen::Mesh> input{this, "input", {.doc = "the surface"}};
  lumen::Property<float> distance{this, "distance", 0.1f, {.unit = "world", .doc = "how far; negative: inward"}};
  lumen::Output<lumen::Mesh> mesh{this, "mesh", {.doc = "the moved surface"}};

  void compute(lumen::Job& job) const override {
    const auto source = job[input];
    if (!source) return;
    const std::vector<glm::vec3> averaged =
        source->normals.empty() ? lumen::average_normals(source->positions, source->triangles) : std::vector<glm::vec3>();
    const std::span<const glm::vec3> normals = averaged.empty() ? source->normals.view() : std::span<const glm::vec3>(averaged);
    std::vector<glm::vec3> positions(source->positions.begin(), source->positions.end());
    for (std::size_t i = 0; i < positions.size(); ++i) {
      if (i % 65536 == 0) job.progress(float(i) / float(positions.size()));
      positions[i] += job[distance] * normals[i];
    }
    auto result = std::make_shared<lumen::Mesh>(*source);
    result->positions = std::move(positions);
    result->finish();
    job.set(mesh, result);
  }
};

}  // namespace

LUMEN_PLUGIN(@Class@, "filter.@name@", "Moves each point of a surface along its normal.")
