/// Warm where the surface faces the light, cool where it turns away, so that edges and highlights keep black and white for themselves. Gooch, Gooch, Shirley, Cohen, A Non-Photorealistic Lighting Model for Automatic Technical Illustration, SIGGRAPH 1998.

#include <lumen/term.h>

namespace {

struct Gooch : lumen::Diffuse {
  using Diffuse::Diffuse;

  lumen::Property<lumen::Color> cool{this, "cool", lumen::Color(0, 0, 0.4f), {.min = 0, .max = 1, .doc = "tone where the surface turns away from the light"}};
  lumen::Property<lumen::Color> warm{this, "warm", lumen::Color(0.4f, 0.4f, 0), {.min = 0, .max = 1, .doc = "tone where the surface faces the light"}};
  lumen::Property<float> alpha{this, "alpha", 0.2f, {.min = 0, .max = 1, .doc = "share of the diffuse color in the cool tone"}};
  lumen::Property<float> beta{this, "beta", 0.6f, {.min = 0, .max = 1, .doc = "share of the diffuse color in the warm tone"}};
};

}  // namespace

LUMEN_PLUGIN(Gooch, "diffuse.gooch", "Warm where the surface faces the light, cool where it turns away, so that edges and highlights keep black and white for themselves. Gooch, Gooch, Shirley, Cohen, A Non-Photorealistic Lighting Model for Automatic Technical Illustration, SIGGRAPH 1998.")
