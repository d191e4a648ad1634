/// Darkens the picture toward its corners, so that the eye stays in the middle. Ostendorf 2021, section 4.

#include <lumen/compositor.h>

namespace {

struct Vignette : lumen::Compositor {
  using Compositor::Compositor;

  lumen::Property<float> radius{this, "radius", 1.8f, {.min = 0, .max = 3, .doc = "where it is complete; 1 is the middle of an edge, 1.41 a corner"}};
  lumen::Property<float> softness{this, "softness", 1.5f, {.min = 0.001, .max = 3, .doc = "how wide the transition is, inward of the radius"}};
  lumen::Property<lumen::Color> color{this, "color", {0, 0, 0}, {.min = 0, .max = 1, .doc = "what the picture fades to"}};

  void render(lumen::Frame& frame) override { frame.fullscreen("compositor/vignette.glsl"); }
};

}  // namespace

LUMEN_PLUGIN(Vignette, "compositor.vignette", "Darkens the picture toward its corners. Ostendorf, Magdeburg 2021, section 4.")
