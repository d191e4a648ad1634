/// What stands behind the scene: a color, or a gradient from top to bottom.

#include <lumen/compositor.h>

namespace {

struct Background : lumen::Compositor {
  using Compositor::Compositor;

  lumen::Property<lumen::Choice> mode{this, "mode", {"gradient"}, {.doc = "one color, or a gradient", .choices = {"color", "gradient"}}};
  lumen::Property<lumen::Color> color{this, "color", {0.84f, 0.84f, 0.81f}, {.min = 0, .max = 1, .doc = "the color, or the top of the gradient"}};
  lumen::Property<lumen::Color> bottom{this, "bottom", {0.58f, 0.58f, 0.56f}, {.min = 0, .max = 1, .doc = "the bottom of the gradient", .when = "mode = gradient"}};

  void render(lumen::Frame& frame) override { frame.fullscreen("compositor/background.glsl"); }
};

}  // namespace

LUMEN_PLUGIN(Background, "compositor.background", "What stands behind the scene: a color, or a gradient from top to bottom.")
