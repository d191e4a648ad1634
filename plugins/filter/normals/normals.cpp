/// Point normals with a choice of weights, and creases.
#include <glm/trigonometric.hpp>

#include <lumen/filter.h>
#include <lumen/mesh.h>

#include "crease.h"

namespace {

/// The tuples of the points that each point is a copy of.
template <class T> lumen::Array<T> follow(const lumen::Array<T>& values, std::span<const std::uint32_t> sources, std::size_t components = 1) {
  if (values.empty()) return {};
  std::vector<T> result;
  result.reserve(sources.size() * components);
  for (const std::uint32_t source : sources) result.insert(result.end(), values.data() + source * components, values.data() + (source + 1) * components);
  return result;
}

struct Normals : lumen::Filter {
  using Filter::Filter;
  lumen::Input<lumen::Mesh> mesh{this, "mesh", {.doc = "the surface"}};
  lumen::Output<lumen::Mesh> result{this, "result", {.doc = "the surface with new normals; points at creases are doubled, their arrays with them"}};
  lumen::Property<float> crease{this, "crease", 30.0f, {.min = 0, .max = 180, .unit = "degrees", .doc = "edges between triangles that differ by more stay sharp; 180: none do"}};
  lumen::Property<lumen::Choice> weighting{this, "weighting", {"area"}, {.doc = "how much a triangle counts at its corners: by its area, by its angle there, or all the same", .choices = {"area", "angle", "uniform"}}};

  void compute(lumen::Job& job) const override {
    const auto input = job[mesh];
    if (!input) throw lumen::Error(std::string("normals.mesh"), "there is no surface", "link a mesh to it");
    const std::string& weights = job[weighting].name;
    const Weighting chosen = weights == "angle" ? Weighting::angle : weights == "uniform" ? Weighting::uniform : Weighting::area;
    auto creases = creased(input->positions, input->triangles, glm::radians(job[crease]), chosen, [&](float part) { job.progress(part); });

    auto output = std::make_shared<lumen::Mesh>(*input);
    if (creases) {
      output->normals = std::move(creases->normals);
      output->triangles = std::move(creases->triangles);
      if (creases->sources.size() > input->positions.size()) {
        output->positions = follow(input->positions, creases->sources);
        output->texture_coordinates = follow(input->texture_coordinates, creases->sources);
        for (lumen::Attribute& attribute : output->attributes)
          if (attribute.on == lumen::Attribute::On::points)
            attribute.values = follow(attribute.values, creases->sources, static_cast<std::size_t>(attribute.components));
      }
    } else {
      job.report(lumen::Severity::warning, input->origin + " is no manifold (an edge of three triangles, or neighbors that face opposite ways): "
                                           "its normals are averaged by area, without creases");
      output->normals = lumen::average_normals(input->positions, input->triangles);
    }
    output->finish();
    job.set(result, output);
  }
};
LUMEN_PLUGIN(Normals, "filter.normals", "point normals by area, angle or equal weights, with creases, on OpenMesh's half-edges")

}  // namespace
