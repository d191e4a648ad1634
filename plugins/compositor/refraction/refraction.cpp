/// What lies behind transparent surfaces, seen through them as through bent glass.
/// Wyman, An Approximate Image-Space Approach for Interactive Refraction, SIGGRAPH 2005; here with one thickness for all surfaces.

#include <lumen/compositor.h>

namespace {

struct Refraction : lumen::Compositor {
  using Compositor::Compositor;

  lumen::Property<float> index{this, "index", 1.33f, {.min = 1, .max = 3, .doc = "refractive index of what the surfaces hold; 1 leaves the picture as it is, 1.33 is water, 1.5 glass"}};
  lumen::Property<float> thickness{this, "thickness", 0.1f, {.min = 0, .max = 2, .unit = "scene radii", .doc = "how far light travels bent before it reaches what is behind"}};

  lumen::Reads front_depth{this, "front_depth"}, front_normal{this, "front_normal"}, opaque{this, "opaque"}, transparent{this, "transparent"}, depth{this, "depth"};

  void render(lumen::Frame& frame) override { frame.fullscreen("compositor/refraction.glsl"); }
};

}  // namespace

LUMEN_PLUGIN(Refraction, "compositor.refraction", "The opaque scene bent by the transparent surfaces in front of it; place it before the background. Wyman, SIGGRAPH 2005.")
