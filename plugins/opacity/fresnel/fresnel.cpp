/// Opaque where the surface turns away from the eye, clear where it faces it: alpha_min + (alpha_max - alpha_min) (1 - |N.V|^falloff). Ostendorf, Applications of Shading and Illumination Algorithms to Vascular 3D Meshes, Magdeburg 2021, eq. 3.38.

#include <lumen/term.h>

namespace {

struct Fresnel : lumen::Opacity {
  using Opacity::Opacity;

  lumen::Property<float> falloff{this, "falloff", 1.0f, {.min = 0.01, .max = 10, .doc = "how narrow the clear middle is; small values leave only the edge opaque", .logarithmic = true}};
  lumen::Property<float> alpha_min{this, "alpha_min", 0.0f, {.min = 0, .max = 1, .doc = "opacity where the surface faces the eye"}};
  lumen::Property<float> alpha_max{this, "alpha_max", 1.0f, {.min = 0, .max = 1, .doc = "opacity at the edge"}};
};

}  // namespace

LUMEN_PLUGIN(Fresnel, "opacity.fresnel", "Opaque where the surface turns away from the eye, clear where it faces it: alpha_min + (alpha_max - alpha_min) (1 - |N.V|^falloff). Ostendorf, Applications of Shading and Illumination Algorithms to Vascular 3D Meshes, Magdeburg 2021, eq. 3.38.")
