/// Fog: what is far fades into a color. Willis, Visual Simulation of Atmospheric Haze, Computer Graphics Forum 1987; the curves
/// are OpenGL's (Segal, Akeley, The OpenGL Graphics System 1.0, 1993). Depth is that of the opaque scene.

#include <lumen/compositor.h>

namespace {

struct Fog : lumen::Compositor {
  using Compositor::Compositor;

  lumen::Property<lumen::Choice> mode{this, "mode", {"linear"}, {.doc = "fades evenly between two depths, exponentially, or exponentially with the square of the depth", .choices = {"linear", "exponential", "exponential_squared"}}};
  lumen::Property<lumen::Color> color{this, "color", {0.84f, 0.84f, 0.81f}, {.min = 0, .max = 1, .doc = "what the scene fades to"}};
  lumen::Property<float> amount{this, "amount", 1.0f, {.min = 0, .max = 1, .doc = "how much of the fog is there; 0 leaves the picture as it is"}};
  lumen::Property<float> start{this, "start", 0.2f, {.min = -1, .max = 2, .unit = "scene depth", .doc = "where it begins; 0 is the near end of the scene, 1 its far end"}};
  lumen::Property<float> end{this, "end", 1.0f, {.min = -1, .max = 2, .unit = "scene depth", .doc = "where nothing but fog is left", .when = "mode = linear"}};
  lumen::Property<float> density{this, "density", 2.0f, {.min = 0, .max = 50, .unit = "per scene depth", .doc = "how fast it thickens behind the start", .when = "mode != linear"}};
  lumen::Property<bool> background{this, "background", false, {.doc = "what stands behind the scene is fog, too; put the fog after compositor.background"}};

  lumen::Reads depth{this, "depth"}, transparent{this, "transparent"};

  void render(lumen::Frame& frame) override { frame.fullscreen("compositor/fog.glsl"); }
};

}  // namespace

LUMEN_PLUGIN(Fog, "compositor.fog", "What is far fades into a color. Willis, Visual Simulation of Atmospheric Haze, Computer Graphics Forum 1987.")
