/// Rough diffuse reflection, flat toward the edges and brighter back toward the light. Oren, Nayar, Generalization of Lambert's Reflectance Model, SIGGRAPH 1994; Portsmouth, Kutz, Hill, EON: A Practical Energy-Preserving Rough Diffuse BRDF, 2024.

#include <lumen/term.h>

namespace {

struct OrenNayar : lumen::Diffuse {
  using Diffuse::Diffuse;

  lumen::Property<lumen::Choice> model{this, "model", lumen::Choice{"qualitative"}, {.doc = "Oren and Nayar's qualitative model, or the one of Portsmouth et al., which loses no light between the facets", .choices = {"qualitative", "energy_preserving"}}};
  lumen::Property<float> sigma{this, "sigma", 0.2f, {.min = 0, .max = 1.5707963, .unit = "radians", .doc = "standard deviation of the facets' slopes; 0 is Lambert", .when = "model = qualitative"}};
  lumen::Property<float> roughness{this, "roughness", 0.5f, {.min = 0, .max = 1, .doc = "0 is Lambert, 1 as rough as the model goes", .when = "model = energy_preserving"}};
};

}  // namespace

LUMEN_PLUGIN(OrenNayar, "diffuse.oren_nayar", "Rough diffuse reflection, flat toward the edges and brighter back toward the light. Oren, Nayar, Generalization of Lambert's Reflectance Model, SIGGRAPH 1994; Portsmouth, Kutz, Hill, EON: A Practical Energy-Preserving Rough Diffuse BRDF, 2024.")
