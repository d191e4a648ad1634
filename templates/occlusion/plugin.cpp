/// Occlusion where the surface lies deeper than its surroundings. Luft, Colditz, Deussen, SIGGRAPH 2006.

#include <lumen/occlusion.h>

namespace {

struct @Class@ : lumen::Occlusion {
  using Occlusion::Occlusion;

  lumen::Property<float> radius{this, "radius", 8.0f, {.min = 1, .max = 64, .unit = "pixels", .doc = "how far the surroundings reach"}};
  lumen::Property<float> strength{this, "strength", 8.0f, {.min = 0, .max = 100, .doc = "occlusion per scene depth"}};

  lumen::Reads depth{this, "depth"};
  lumen::Writes occlusion{this, "occlusion", lumen::Format::R32F};

  void render(lumen::Frame& frame) override { frame.fullscreen("occlusion/@name@.glsl", {.covered_only = true}); }
};

}  // namespace

LUMEN_PLUGIN(@Class@, "occlusion.@name@", "Occlusion where the surface lies deeper than its surroundings. Luft et al., SIGGRAPH 2006.")
