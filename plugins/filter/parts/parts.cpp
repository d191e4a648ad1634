/// Parts of a mesh that connection does not tell apart: thick and thin ones, as organs on their vessels. After Shapira, Shamir, Cohen-Or, Consistent
/// Mesh Partitioning and Skeletonisation using the Shape Diameter Function, The Visual Computer 24, 2008.
#include <algorithm>

#include <lumen/components.h>
#include <lumen/filter.h>
#include <lumen/mesh.h>

#include "partition.h"
#include "seams.h"
#include "thickness.h"
#include "threshold.h"

namespace {

/// The mesh with an array in place of what had its name.
void put(lumen::Mesh& mesh, lumen::Attribute attribute) {
  std::erase_if(mesh.attributes, [&](const lumen::Attribute& other) { return other.name == attribute.name; });
  mesh.attributes.push_back(std::move(attribute));
}

/// Of each source cell, the part of its largest triangle.
lumen::Attribute part_of_cells(const lumen::Mesh& mesh, const Surface& surface, const Partition& partition) {
  const auto cell = [&](std::size_t triangle) { return mesh.triangle_cells.empty() ? triangle : std::size_t(mesh.triangle_cells[triangle]); };
  std::size_t cells = 0;
  for (std::size_t i = 0; i < surface.size(); ++i) cells = std::max(cells, cell(i) + 1);
  std::vector<float> parts(cells, 0.0f), largest(cells, -1.0f);
  for (std::size_t i = 0; i < surface.size(); ++i)
    if (surface.area(i) > largest[cell(i)]) largest[cell(i)] = surface.area(i), parts[cell(i)] = float(partition.of_triangle[i]);
  return {.name = lumen::part_array, .on = lumen::Attribute::On::cells, .components = 1, .values = std::move(parts)};
}

/// Of each point, the mean of the triangles around its place.
lumen::Attribute thickness_of_points(const lumen::Mesh& mesh, const Surface& surface, std::span<const float> thickness) {
  std::vector<float> sum(mesh.positions.size(), 0.0f), weight(mesh.positions.size(), 0.0f);
  for (std::size_t i = 0; i < surface.size(); ++i)
    for (int k = 0; k < 3; ++k) sum[surface.corners(i)[k]] += surface.area(i) * thickness[i], weight[surface.corners(i)[k]] += surface.area(i);
  std::vector<float> values(mesh.positions.size(), 0.0f);
  for (std::size_t i = 0; i < surface.size(); ++i)
    for (int k = 0; k < 3; ++k)
      if (const std::uint32_t place = surface.corners(i)[k]; weight[place] > 0) values[mesh.triangles[i][surface.source_corner(i, k)]] = sum[place] / weight[place];
  return {.name = "thickness", .on = lumen::Attribute::On::points, .components = 1, .values = std::move(values)};
}

struct Parts : lumen::Filter {
  using Filter::Filter;

  lumen::Input<lumen::Mesh> mesh{this, "mesh", {.doc = "the surface"}};
  lumen::Output<lumen::Mesh> result{this, "result", {.doc = "the surface with the cell array `component`, the largest is 0, and by thickness the point array `thickness`"}};
  lumen::Property<lumen::Choice> by{this, "by", {"thickness"}, {.doc = "thick parts and thin ones, or connected ones", .choices = {"thickness", "connected"}}};
  lumen::Property<float> threshold{this, "threshold", 0.0f, {.min = 0, .unit = "world", .doc = "what is thicker is thick; 0: where it divides the surface best", .when = "by = thickness"}};
  lumen::Property<float> smallest{this, "smallest", 0.005f, {.min = 0, .max = 0.5, .doc = "share of the area below which a part joins its neighbor, or is a speck"}};
  lumen::Property<lumen::Choice> specks{this, "specks", {"join"}, {.doc = "connected pieces that are too small: parts of their own, of the nearest part, or together the last part", .choices = {"keep", "join", "last"}}};
  lumen::Property<float> seams{this, "seams", 0.5f, {.min = 0, .max = 2, .unit = "thicknesses", .doc = "how far seams move to where they are short and lie in folds", .when = "by = thickness"}};
  lumen::Property<float> cone{this, "cone", 60.0f, {.min = 1, .max = 160, .unit = "degrees", .doc = "opening of the cone of rays that measure the thickness", .group = "Rays", .when = "by = thickness", .advanced = true}};
  lumen::Property<int> rays{this, "rays", 24, {.min = 1, .max = 256, .doc = "of each sample", .group = "Rays", .when = "by = thickness", .advanced = true}};
  lumen::Property<int> samples{this, "samples", 40000, {.min = 100, .max = 10000000, .unit = "triangles", .doc = "how many send rays, at most; the others follow", .group = "Rays", .when = "by = thickness", .logarithmic = true, .advanced = true}};
  lumen::Property<int> smoothing{this, "smoothing", 4, {.min = 0, .max = 64, .unit = "rounds", .doc = "of the thickness, over neighboring samples", .group = "Rays", .when = "by = thickness", .advanced = true}};

  void compute(lumen::Job& job) const override {
    const auto input = job[mesh];
    if (!input) throw lumen::Error("parts.mesh", "there is no surface", "link a mesh to it");
    job.progress(0);
    const Surface surface(*input);
    auto output = std::make_shared<lumen::Mesh>(*input);
    Partition partition;
    if (job[by].name == "thickness") {
      const std::vector<float> thickness = measured(job, *input, surface);
      partition = by_thickness(job, surface, thickness);
      put(*output, thickness_of_points(*input, surface, thickness));
    } else {
      partition = partition_of(surface, lumen::connected_parts(*input).of_triangle);
    }
    const Specks kept = job[specks].name == "keep" ? Specks::keep : job[specks].name == "last" ? Specks::last : Specks::join;
    put(*output, part_of_cells(*input, surface, numbered(surface, partition, job[smallest], kept)));
    output->finish();
    job.set(result, output);
  }

 private:
  static constexpr float alike = 1.4f;  ///< classes whose means differ by less are one

  std::vector<float> measured(lumen::Job& job, const lumen::Mesh& mesh, const Surface& surface) const {
    const ThicknessOptions options{.rays = job[rays], .cone = job[cone], .samples = std::size_t(job[samples]), .smoothing = job[smoothing]};
    job.progress(0.1f);
    std::vector<float> thickness = thickness_of(surface, options, [&](float part) { job.progress(0.1f + 0.6f * part); });
    if (std::all_of(thickness.begin(), thickness.end(), [](float value) { return value == 0; }))
      throw lumen::Error("parts.mesh", "'" + mesh.origin + "' encloses nothing that could be thick or thin", "set by to connected");
    if (surface.border_edges() > 0)
      job.report(lumen::Severity::note, "'" + mesh.origin + "' is open (" + lumen::grouped(surface.border_edges()) + " border edges): it is taken to face outward, and where rays leave it, it is as thick as beside");
    return thickness;
  }

  Partition by_thickness(lumen::Job& job, const Surface& surface, const std::vector<float>& thickness) const {
    const std::optional<float> limit = job[threshold] > 0 ? job[threshold] : dividing_thickness(thickness, surface.areas(), alike);
    std::vector<bool> thick(surface.size(), false);
    if (limit)
      for (std::size_t i = 0; i < thick.size(); ++i) thick[i] = thickness[i] >= *limit;
    job.progress(0.7f);
    Partition partition = absorbed(surface, runs_of(surface, thick), job[smallest]);
    job.progress(0.8f);
    return with_best_seams(surface, std::move(partition), thickness, job[seams], [&](float part) { job.progress(0.8f + 0.2f * part); });
  }
};

}  // namespace

LUMEN_PLUGIN(Parts, "filter.parts", "Thick and thin parts of a surface, as organs on their vessels, or its connected ones. Shapira, Shamir, Cohen-Or, The Visual Computer 2008.")
