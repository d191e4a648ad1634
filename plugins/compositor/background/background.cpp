/// What stands behind the scene: a color, a gradient from top to bottom, or a picture.

#include <lumen/compositor.h>
#include <lumen/image.h>

namespace {

struct Background : lumen::Compositor {
  using Compositor::Compositor;

  lumen::Property<lumen::Choice> mode{this, "mode", {"gradient"}, {.doc = "one color, a gradient, or a picture", .choices = {"color", "gradient", "image"}, .constant = true}};
  lumen::Property<lumen::Color> color{this, "color", {0.84f, 0.84f, 0.81f}, {.min = 0, .max = 1, .doc = "the color, or the top of the gradient; beside a picture that does not fill the view"}};
  lumen::Property<lumen::Color> bottom{this, "bottom", {0.58f, 0.58f, 0.56f}, {.min = 0, .max = 1, .doc = "the bottom of the gradient", .when = "mode = gradient"}};
  lumen::Input<lumen::Image> image{this, "image", {.doc = "the picture", .when = "mode = image"}};
  lumen::Property<lumen::Choice> fit{this, "fit", {"cover"}, {.doc = "fill the view and crop the picture, show all of it, or stretch it", .when = "mode = image", .choices = {"cover", "contain", "stretch"}}};

  void render(lumen::Frame& frame) override { frame.fullscreen("compositor/background.glsl"); }
};

}  // namespace

LUMEN_PLUGIN(Background, "compositor.background", "What stands behind the scene: a color, a gradient from top to bottom, or a picture.")
