/// Ambient occlusion from sectors of slices that samples of a certain thickness cover: light passes behind thin things.
/// Therrien, Levesque, Gilbert, Screen Space Indirect Lighting with Visibility Bitmask, The Visual Computer 2023.

#include "../screen_space.h"

namespace {

struct Bitmask : ScreenSpace {
  explicit Bitmask(lumen::Binding& binding) : ScreenSpace(binding, "occlusion/bitmask.glsl", {.radius = 0.25f, .refinements = 8}) {}

  lumen::Property<float> thickness{this, "thickness", 0.1f, {.min = 0.001, .max = 4, .unit = "scene radii", .doc = "how far a surface reaches back from what is seen of it", .logarithmic = true}};
  lumen::Property<int> slices{this, "slices", 2, {.min = 1, .max = 32, .doc = "planes through the eye's direction per pixel and refinement", .constant = true}};
  lumen::Property<int> steps{this, "steps", 8, {.min = 1, .max = 64, .doc = "taps on either side of a slice", .constant = true}};
};

}  // namespace

LUMEN_PLUGIN(Bitmask, "occlusion.bitmask", "Ambient occlusion from visibility bitmasks, right for thin things. Therrien, Levesque, Gilbert, The Visual Computer 2023.")
