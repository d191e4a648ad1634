/// A generated aortic dissection: a mesh of any size whose truth is known.
#include <cmath>

#include <lumen/importer.h>
#include <lumen/mesh.h>

#include "anatomy.h"
#include "flap.h"

namespace {

/// Cells of one size for all parts, so that their triangles add up to the number that was asked for.
struct Plan {
  float edge = 1;               ///< millimeters
  std::vector<TubeGrid> wall;
  TubeGrid lumen;
};

std::size_t count(const Plan& plan, const Flap& flap) {
  std::size_t triangles = plan.lumen.triangles() + flap.estimate(plan.edge);
  for (const TubeGrid& grid : plan.wall) triangles += grid.triangles();
  return triangles;
}

Plan plan_of(const Anatomy& anatomy, const Flap& flap, std::size_t triangles) {
  const auto with_edge = [&](float edge) {
    Plan plan{edge, {}, grid_of(anatomy.lumen(), edge)};
    for (const Tube& tube : anatomy.wall()) plan.wall.push_back(grid_of(tube, edge));
    return plan;
  };
  float fine = 0.02f, coarse = 200;
  for (int step = 0; step < 40; ++step) {
    const float middle = std::sqrt(fine * coarse);
    (count(with_edge(middle), flap) > triangles ? fine : coarse) = middle;
  }
  return with_edge(coarse);
}

/// The rings of the aorta take up what the rounding of the others left over or took.
void settle(TubeGrid& aorta, std::size_t present, std::size_t wanted) {
  const auto difference = static_cast<std::ptrdiff_t>(wanted) - static_cast<std::ptrdiff_t>(present);
  aorta.rings = static_cast<int>(std::max(std::ptrdiff_t{4}, aorta.rings + difference / (2 * aorta.around)));
}

struct Phantom : lumen::Importer {
  using Importer::Importer;
  lumen::Property<int> triangles{this, "triangles", 100000, {.min = 1000, .max = 4000000, .unit = "triangles", .doc = "of all parts together, within 5 percent", .logarithmic = true}};
  lumen::Property<int> seed{this, "seed", 1, {.min = 0, .max = 1000000, .doc = "which individual: the same number gives the same vessel"}};
  lumen::Property<float> bend{this, "bend", 1.0f, {.min = 0, .max = 1.2, .doc = "how much the vessel bends: 0 straight, 1 a natural arch", .group = "Vessel"}};
  lumen::Property<float> irregularity{this, "irregularity", 0.03f, {.min = 0, .max = 0.1, .unit = "radii", .doc = "bumps of the wall", .group = "Vessel"}};
  lumen::Property<bool> branches{this, "branches", true, {.doc = "supra-aortic, visceral, renal and iliac arteries", .group = "Vessel"}};
  lumen::Property<float> false_lumen{this, "false_lumen", 0.65f, {.min = 0.3, .max = 0.85, .doc = "share of the diameter that the false lumen takes", .group = "Dissection"}};
  lumen::Property<float> twist{this, "twist", 0.6f, {.min = -2, .max = 2, .unit = "turns", .doc = "how far the flap winds around the axis", .group = "Dissection"}};
  lumen::Property<float> tear{this, "tear", 18.0f, {.min = 0, .max = 40, .unit = "mm", .doc = "length of the entry tear; the re-entry is about half of it", .group = "Dissection"}};
  lumen::Property<float> thickness{this, "thickness", 1.2f, {.min = 0.2, .max = 4, .unit = "mm", .doc = "of the flap", .group = "Dissection"}};

  lumen::Output<lumen::Mesh> wall{this, "wall", {.doc = "the outside of the aorta and its branches"}};
  lumen::Output<lumen::Mesh> lumen_output{this, "lumen", {.doc = "the true lumen"}};
  lumen::Output<lumen::Mesh> flap{this, "flap", {.doc = "the membrane between true and false lumen, with its tears"}};
  lumen::Output<lumen::Mesh> mesh{this, "mesh", {.doc = "all parts in one; the cell array `part` is 0 wall, 1 lumen, 2 flap"}};

  void compute(lumen::Job& job) const override {
    const Anatomy anatomy({job[seed], job[bend], job[twist], job[irregularity], job[false_lumen], job[branches]});
    const Flap membrane(anatomy, {job[tear], job[thickness]});
    const auto wanted = static_cast<std::size_t>(job[triangles]);
    Plan plan = plan_of(anatomy, membrane, wanted);
    const auto share = [&job](float begin, float end) { return [&job, begin, end](float part) { job.progress(begin + (end - begin) * part); }; };

    Shell flap_shell, lumen_shell, wall_shell;
    flap_shell.reserve(membrane.estimate(plan.edge));
    membrane.add(flap_shell, plan.edge, share(0, 0.3f));
    lumen_shell.reserve(plan.lumen.triangles());
    add_tube(lumen_shell, anatomy.lumen(), plan.lumen, share(0.3f, 0.5f));
    std::size_t present = flap_shell.triangles.size() + plan.lumen.triangles();
    for (const TubeGrid& grid : plan.wall) present += grid.triangles();
    settle(plan.wall.front(), present, wanted);
    wall_shell.reserve(wanted - std::min(wanted, flap_shell.triangles.size() + lumen_shell.triangles.size()));
    for (std::size_t tube = 0; tube < plan.wall.size(); ++tube)
      add_tube(wall_shell, anatomy.wall()[tube], plan.wall[tube], tube == 0 ? share(0.5f, 0.7f) : share(0.7f, 0.8f));

    job.progress(0.8f);
    Shell all;
    all.reserve(wanted);
    std::vector<float> parts;
    const Shell* const shells[] = {&wall_shell, &lumen_shell, &flap_shell};
    for (int part = 0; part < 3; ++part) {
      all.append(*shells[part]);
      parts.resize(all.triangles.size(), static_cast<float>(part));
    }
    const auto joined = mesh_of(std::move(all), "aortic dissection");
    joined->attributes.push_back({"part", lumen::Attribute::On::cells, 1, std::move(parts)});
    job.progress(0.9f);
    job.set(wall, mesh_of(std::move(wall_shell), "aortic wall"));
    job.set(lumen_output, mesh_of(std::move(lumen_shell), "true lumen"));
    job.set(flap, mesh_of(std::move(flap_shell), "dissection flap"));
    job.set(mesh, joined);
  }
};
LUMEN_PLUGIN(Phantom, "importer.phantom", "a generated aortic dissection: wall with branches, true lumen and torn flap, of any number of triangles")

}  // namespace
