/// Curvature at the points of a surface, as tensors and as numbers.
#include <algorithm>
#include <cmath>

#include <glm/trigonometric.hpp>

#include <lumen/filter.h>
#include <lumen/mesh.h>

#include "curvature_tensors.h"
#include "inward_parts.h"
#include "welded_surface.h"

namespace {

/// What each point of a mesh is given.
struct PointValues {
  std::vector<float> tensors, mean, gaussian;

  explicit PointValues(std::size_t points) {
    tensors.reserve(6 * points);
    mean.reserve(points);
    gaussian.reserve(points);
  }
  void add(const glm::mat3& c) {
    tensors.insert(tensors.end(), {c[0][0], c[1][1], c[2][2], c[0][1], c[1][2], c[2][0]});
    mean.push_back((c[0][0] + c[1][1] + c[2][2]) / 2);
    // One of the principal curvatures is 0, along the normal: what is left of the second invariant is the product of the others.
    gaussian.push_back(c[0][0] * c[1][1] + c[1][1] * c[2][2] + c[2][2] * c[0][0] - c[0][1] * c[0][1] - c[1][2] * c[1][2] - c[2][0] * c[2][0]);
  }
};

void replace(lumen::Mesh& mesh, const char* name, int components, std::vector<float> values) {
  std::erase_if(mesh.attributes, [&](const lumen::Attribute& attribute) { return attribute.name == name; });
  mesh.attributes.push_back({name, lumen::Attribute::On::points, components, std::move(values)});
}

struct Curvature : lumen::Filter {
  using Filter::Filter;
  lumen::Input<lumen::Mesh> mesh{this, "mesh", {.doc = "the surface"}};
  lumen::Output<lumen::Mesh> result{this, "result", {.doc = "the surface with the arrays curvature (the tensor: xx, yy, zz, xy, yz, zx), mean_curvature and gaussian_curvature; with normals if it had none, and with closed parts that are inside out turned outward"}};
  lumen::Property<int> smoothing{this, "smoothing", 0, {.min = 0, .max = 100, .unit = "passes", .doc = "how often the curvature of each point becomes half its own, half that of its neighbors: against noise"}};
  lumen::Property<float> crease{this, "crease", 30.0f, {.min = 5, .max = 180, .unit = "degrees", .doc = "points at one place count as one, unless their normals differ by more"}};

  void compute(lumen::Job& job) const override {
    const auto input = job[mesh];
    if (!input) throw lumen::Error(id() + ".mesh", "there is no surface", "link a mesh to it");
    WeldedSurface surface = welded(*input, glm::radians(double(job[crease])), [&](float part) { job.progress(0.2f * part); });
    const std::vector<bool> inward = inward_points(surface, [&](float part) { job.progress(0.2f + 0.1f * part); });
    for (std::size_t point = 0; point < inward.size(); ++point)
      if (inward[point]) surface.normals[point] = -surface.normals[point];
    const CurvatureTensors found = curvature_of(surface, job[smoothing], [&](float part) { job.progress(0.3f + 0.7f * part); });
    if (found.unknown > 0)
      job.report(lumen::Severity::note, lumen::grouped(found.unknown) + " points of " + input->origin +
                                            " have no curvature: their triangles have no area, or face opposite ways");

    PointValues values(input->positions.size());
    for (const std::uint32_t point : surface.number) values.add(found.tensors[point]);
    auto output = std::make_shared<lumen::Mesh>(*input);
    replace(*output, "curvature", 6, std::move(values.tensors));
    replace(*output, "mean_curvature", 1, std::move(values.mean));
    replace(*output, "gaussian_curvature", 1, std::move(values.gaussian));
    std::vector<glm::vec3> normals;
    normals.reserve(surface.number.size());
    for (std::size_t point = 0; point < surface.number.size(); ++point) {
      const std::uint32_t number = surface.number[point];
      normals.push_back(input->normals.empty() ? glm::vec3(surface.normals[number]) : inward[number] ? -input->normals[point] : input->normals[point]);
    }
    output->normals = std::move(normals);
    if (std::find(inward.begin(), inward.end(), true) != inward.end()) {
      std::vector<glm::uvec3> triangles(input->triangles.begin(), input->triangles.end());
      for (glm::uvec3& t : triangles)
        if (inward[surface.number[t.x]]) t = {t.x, t.z, t.y};
      output->triangles = std::move(triangles);
    }
    output->finish();
    job.set(result, output);
  }
};
LUMEN_PLUGIN(Curvature, "filter.curvature", "how a surface bends at its points: curvature tensors, mean and Gaussian curvature. Rusinkiewicz, Estimating Curvatures and Their Derivatives on Triangle Meshes, 3DPVT 2004")

}  // namespace
