/// Tints the picture.

#include <lumen/compositor.h>

namespace {

struct @Class@ : lumen::Compositor {
  using Compositor::Compositor;

  lumen::Property<lumen::Color> tint{this, "tint", {1, 0.9f, 0.75f}, {.min = 0, .max = 1, .doc = "what the picture is multiplied by"}};

  void render(lumen::Frame& frame) override { frame.fullscreen("compositor/@name@.glsl"); }
};

}  // namespace

LUMEN_PLUGIN(@Class@, "compositor.@name@", "Tints the picture.")
