/// Ambient occlusion from the horizons of slices through the eye's direction, cosine-weighted.
/// Jimenez, Wu, Pesce, Jarabo, Practical Realtime Strategies for Accurate Indirect Occlusion, SIGGRAPH 2016 courses.

#include "../screen_space.h"

namespace {

struct Gtao : ScreenSpace {
  explicit Gtao(lumen::Binding& binding) : ScreenSpace(binding, "occlusion/gtao.glsl", {.radius = 0.25f, .refinements = 8}) {}

  lumen::Property<int> slices{this, "slices", 2, {.min = 1, .max = 32, .doc = "planes through the eye's direction per pixel and refinement", .constant = true}};
  lumen::Property<int> steps{this, "steps", 8, {.min = 1, .max = 64, .doc = "taps on either side of a slice", .constant = true}};
};

}  // namespace

LUMEN_PLUGIN(Gtao, "occlusion.gtao", "Ground-truth ambient occlusion of what the picture shows. Jimenez et al., SIGGRAPH 2016 courses.")
