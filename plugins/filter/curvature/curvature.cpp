/// Curvature at the points of a surface, as tensors and as numbers.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <lumen/filter.h>
#include <lumen/mesh.h>
#include <topology/orientation.h>

#include "curvature_tensors.h"
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

/// The mesh, its triangles facing out of the solid that it encloses, if it does, and its normals with them.
std::shared_ptr<lumen::Mesh> outward(const lumen::Mesh& mesh) {
  auto result = std::make_shared<lumen::Mesh>(mesh);
  const std::vector<bool> turned = lumen::orientation_of(mesh).turned;
  if (turned.empty()) return result;
  std::vector<glm::uvec3> triangles(mesh.triangles.begin(), mesh.triangles.end());
  std::vector<glm::vec3> sums(mesh.positions.size(), glm::vec3(0)), normals(mesh.normals.begin(), mesh.normals.end());
  std::vector<bool> of_turned(mesh.positions.size(), false);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    glm::uvec3& t = triangles[i];
    if (turned[i]) t = {t.x, t.z, t.y};
    const glm::vec3 face = glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]);
    for (int corner = 0; corner < 3; ++corner) {
      sums[t[corner]] += face;
      if (turned[i]) of_turned[t[corner]] = true;
    }
  }
  for (std::size_t point = 0; point < normals.size(); ++point) {
    const float side = glm::dot(normals[point], sums[point]);
    if (side < 0 || (side == 0 && of_turned[point])) normals[point] = -normals[point];  // its triangles may have no area
  }
  result->triangles = std::move(triangles);
  result->normals = std::move(normals);
  return result;
}

struct Curvature : lumen::Filter {
  using Filter::Filter;
  lumen::Input<lumen::Mesh> mesh{this, "mesh", {.doc = "the surface"}};
  lumen::Output<lumen::Mesh> result{this, "result", {.doc = "the surface with the arrays curvature (the tensor: xx, yy, zz, xy, yz, zx), mean_curvature and gaussian_curvature; with normals if it had none, and with triangles turned outward where it is closed"}};
  lumen::Property<int> smoothing{this, "smoothing", 0, {.min = 0, .max = 100, .unit = "passes", .doc = "how often the curvature of each point becomes half its own, half that of its neighbors: against noise"}};
  lumen::Property<float> crease{this, "crease", 30.0f, {.min = 5, .max = 180, .unit = "degrees", .doc = "points at one place count as one, unless their normals differ by more"}};

  void compute(lumen::Job& job) const override {
    const auto input = job[mesh];
    if (!input) throw lumen::Error(id() + ".mesh", "there is no surface", "link a mesh to it");
    auto output = outward(*input);
    const WeldedSurface surface = welded(*output, glm::radians(double(job[crease])), [&](float part) { job.progress(0.3f * part); });
    const CurvatureTensors found = curvature_of(surface, job[smoothing], [&](float part) { job.progress(0.3f + 0.7f * part); });
    if (found.unknown > 0)
      job.report(lumen::Severity::note, lumen::grouped(found.unknown) + " points of " + input->origin +
                                            " have no curvature: their triangles have no area, or face opposite ways");

    PointValues values(input->positions.size());
    for (const std::uint32_t point : surface.number) values.add(found.tensors[point]);
    replace(*output, "curvature", 6, std::move(values.tensors));
    replace(*output, "mean_curvature", 1, std::move(values.mean));
    replace(*output, "gaussian_curvature", 1, std::move(values.gaussian));
    if (output->normals.empty()) {
      std::vector<glm::vec3> normals;
      normals.reserve(surface.number.size());
      for (const std::uint32_t point : surface.number) normals.emplace_back(surface.normals[point]);
      output->normals = std::move(normals);
    }
    output->finish();
    job.set(result, output);
  }
};

}  // namespace

LUMEN_PLUGIN(Curvature, "filter.curvature", "how a surface bends at its points: curvature tensors, mean and Gaussian curvature. Rusinkiewicz, Estimating Curvatures and Their Derivatives on Triangle Meshes, 3DPVT 2004")
