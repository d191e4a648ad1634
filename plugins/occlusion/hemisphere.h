/// What occlusions share that compare a hemisphere of samples around the normal with stored depths: lib/hemisphere.glsl.
#pragma once

#include "screen_space.h"

class HemisphereOcclusion : public ScreenSpace {
 public:
  struct Defaults {
    ScreenSpace::Defaults common = {};
    int samples = 32;
  };
  HemisphereOcclusion(lumen::Binding& binding, const char* shader, const Defaults& defaults)
      : ScreenSpace(binding, shader, defaults.common),
        samples(this, "samples", defaults.samples, {.min = 1, .max = 256, .doc = "taps per pixel, in pairs on either side of the normal", .constant = true}) {}

  lumen::Property<float> bias{this, "bias", 0.05f, {.min = 0, .max = 2, .unit = "radii", .doc = "how much nearer than a sample the surface must be to occlude it; hides steps of the depth"}};
  lumen::Property<int> samples;
};
