/// A torus.

#include <cmath>
#include <numbers>

#include <lumen/importer.h>
#include <lumen/mesh.h>

namespace {

struct @Class@ : lumen::Importer {
  using Importer::Importer;

  lumen::Property<float> radius{this, "radius", 1.0f, {.min = 0.01, .max = 100, .unit = "world", .doc = "of the ring"}};
  lumen::Property<float> thickness{this, "thickness", 0.3f, {.min = 0.01, .max = 100, .unit = "world", .doc = "radius of the tube"}};
  lumen::Property<int> segments{this, "segments", 96, {.min = 3, .max = 2000, .doc = "around the ring; a third of them around the tube"}};
  lumen::Output<lumen::Mesh> mesh{this, "mesh", {.doc = "the surface"}};

  void compute(lumen::Job& job) const override {
    const int rings = job[segments], sides = std::max(rings / 3, 3);
    std::vector<glm::vec3> positions, normals;
    std::vector<glm::uvec3> triangles;
    for (int ring = 0; ring < rings; ++ring) {
      job.progress(float(ring) / float(rings));
      const float around = 2 * std::numbers::pi_v<float> * float(ring) / float(rings);
      const glm::vec3 outward(std::cos(around), std::sin(around), 0);
      for (int side = 0; side < sides; ++side) {
        const float turn = 2 * std::numbers::pi_v<float> * float(side) / float(sides);
        const glm::vec3 normal = std::cos(turn) * outward + glm::vec3(0, 0, std::sin(turn));
        normals.push_back(normal);
        positions.push_back(job[radius] * outward + job[thickness] * normal);
        const auto at = [&](int r, int s) { return std::uint32_t((r % rings) * sides + s % sides); };
        triangles.emplace_back(at(ring, side), at(ring + 1, side), at(ring + 1, side + 1));
        triangles.emplace_back(at(ring, side), at(ring + 1, side + 1), at(ring, side + 1));
      }
    }
    auto result = std::make_shared<lumen::Mesh>();
    result->positions = std::move(positions);
    result->normals = std::move(normals);
    result->triangles = std::move(triangles);
    result->origin = "torus";
    result->finish();
    job.set(mesh, result);
  }
};

}  // namespace

LUMEN_PLUGIN(@Class@, "importer.@name@", "A torus.")
