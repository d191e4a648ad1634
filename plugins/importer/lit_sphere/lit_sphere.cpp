/// Pictures of shaded spheres, for lit-sphere terms: a gallery of materials, computed from formulas.
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include <lumen/image.h>
#include <lumen/importer.h>

#include "materials.h"

namespace {

struct LitSphereImporter : lumen::Importer {
  using Importer::Importer;
  lumen::Property<lumen::Choice> material{this, "material", {"clay"}, {.doc = "what the sphere is made of; the highlights are for specular.lit_sphere", .choices = material_names()}};
  lumen::Property<int> size{this, "size", 256, {.min = 16, .max = 2048, .unit = "pixels", .doc = "width and height of the picture", .logarithmic = true}};
  lumen::Property<glm::vec3> direction{this, "direction", glm::vec3(0, 0, 1), {.min = -1, .max = 1, .doc = "toward the picture's own light: x right, y up, z to the eye; the middle (0, 0, 1) suits light space"}};
  lumen::Property<lumen::Choice> mapping{this, "mapping", {"orthographic"}, {.doc = "as a rendered sphere, or by the angle from the middle, half a turn across: the term must be told", .choices = {"orthographic", "equidistant"}, .advanced = true}};
  lumen::Output<lumen::Image> image{this, "image", {.doc = "the picture; beyond the sphere its edge goes on outward"}};

  void compute(lumen::Job& job) const override {
    const Material* shown = &materials().front();
    for (const Material& each : materials())
      if (job[material] == each.name) shown = &each;
    const int side = job[size];
    const bool equidistant = job[mapping] == "equidistant";
    const glm::vec3 given = job[direction];
    const glm::vec3 to_light = glm::dot(given, given) > 1e-12f ? glm::normalize(given) : glm::vec3(0, 0, 1);

    std::vector<float> pixels;
    pixels.reserve(std::size_t(side) * std::size_t(side) * 3);
    for (int y = 0; y < side; ++y) {
      if (y % 64 == 0) job.progress(float(y) / float(side));
      for (int x = 0; x < side; ++x) {
        const glm::vec2 place((float(x) + 0.5f) / float(side) * 2 - 1, 1 - (float(y) + 0.5f) / float(side) * 2);
        const glm::vec3 color = shown->color({normal_at(place, equidistant), to_light});
        pixels.insert(pixels.end(), {color.r, color.g, color.b});
      }
    }
    auto picture = std::make_shared<lumen::Image>();
    picture->width = picture->height = side;
    picture->channels = {"R", "G", "B"};
    picture->pixels = std::move(pixels);
    picture->origin = job[material].name;
    picture->finish();
    job.set(image, picture);
  }

 private:
  /// The sphere's normal at a place of the picture, whose edges are at -1 and 1; the silhouette's beyond it.
  static glm::vec3 normal_at(glm::vec2 place, bool equidistant) {
    const float distance = glm::length(place), inside = std::min(distance, 1.0f);
    const float sine = equidistant ? std::sin(inside * std::numbers::pi_v<float> / 2) : inside;
    return {distance > 0 ? place * (sine / distance) : glm::vec2(0), std::sqrt(std::max(0.0f, 1 - sine * sine))};
  }
};

}  // namespace

LUMEN_PLUGIN(LitSphereImporter, "importer.lit_sphere", "pictures of shaded spheres for lit-sphere terms: a gallery of materials, from formulas")
