/// Ambient occlusion from a hemisphere of samples around the normal, compared with the stored depth.
/// Mittring, Finding Next Gen: CryEngine 2, SIGGRAPH 2007 courses; the hemisphere after Ostendorf 2021, section 3.7.

#include "../screen_space.h"

namespace {

struct Ssao : ScreenSpace {
  explicit Ssao(lumen::Binding& binding) : ScreenSpace(binding, "occlusion/ssao.glsl", {.radius = 0.05f, .refinements = 1}) {}

  lumen::Property<float> bias{this, "bias", 0.05f, {.min = 0, .max = 2, .unit = "radii", .doc = "how much nearer than a sample the surface must be to occlude it; hides steps of the depth"}};
  lumen::Property<int> samples{this, "samples", 32, {.min = 1, .max = 256, .doc = "taps per pixel, in pairs on either side of the normal", .constant = true}};
};

}  // namespace

LUMEN_PLUGIN(Ssao, "occlusion.ssao", "Ambient occlusion from a hemisphere of samples. Mittring, Finding Next Gen: CryEngine 2, SIGGRAPH 2007 courses.")
