/// Ambient occlusion from the horizons around a pixel, each direction of the sky counting alike.
/// Bavoil, Sainz, Dimitrov, Image-Space Horizon-Based Ambient Occlusion, SIGGRAPH 2008 talks.

#include "../screen_space.h"

namespace {

struct Hbao : ScreenSpace {
  explicit Hbao(lumen::Binding& binding) : ScreenSpace(binding, "occlusion/hbao.glsl", {.radius = 0.2f, .refinements = 8}) {}

  lumen::Property<float> bias{this, "bias", 10.0f, {.min = 0, .max = 60, .unit = "degrees", .doc = "how far over the tangent plane an occluder must rise; hides flat facets"}};
  lumen::Property<int> directions{this, "directions", 4, {.min = 1, .max = 64, .doc = "searched around a pixel per refinement", .constant = true}};
  lumen::Property<int> steps{this, "steps", 8, {.min = 1, .max = 64, .doc = "taps along a direction", .constant = true}};
};

}  // namespace

LUMEN_PLUGIN(Hbao, "occlusion.hbao", "Horizon-based ambient occlusion, not weighted by the cosine. Bavoil, Sainz, Dimitrov, SIGGRAPH 2008 talks.")
