/// Depth-dependent halos: what is in front is set off by a border on what is behind it, the wider the farther that is.
/// Everts, Bekker, Roerdink, Isenberg, Depth-Dependent Halos: Illustrative Rendering of Dense Line Data, IEEE TVCG 2009; for
/// surfaces, whose own slope and background count as the lines' displaced strips do there.

#include <lumen/compositor.h>

namespace {

struct Halos : lumen::Compositor {
  using Compositor::Compositor;

  lumen::Property<float> width{this, "width", 6.0f, {.min = 0, .max = 32, .unit = "pixels", .doc = "of the widest halo"}};
  lumen::Property<float> full{this, "full", 0.3f, {.min = 0.001, .max = 4, .unit = "scene radii", .doc = "how far in front a surface must be to have the widest halo; half as far, half as wide", .logarithmic = true}};
  lumen::Property<lumen::Color> color{this, "color", {1, 1, 1}, {.min = 0, .max = 1, .doc = "of the halos"}};
  lumen::Property<float> strength{this, "strength", 1.0f, {.min = 0, .max = 1, .doc = "opacity of the halos; 0 leaves the picture as it is"}};
  lumen::Property<bool> background{this, "background", false, {.doc = "halos on what stands behind the scene, too"}};

  lumen::Reads depth{this, "depth"}, normal{this, "normal"};

  void render(lumen::Frame& frame) override { frame.fullscreen("compositor/halos.glsl"); }
};

}  // namespace

LUMEN_PLUGIN(Halos, "compositor.halos", "Borders around what is in front. Everts, Bekker, Roerdink, Isenberg, Depth-Dependent Halos, IEEE TVCG 2009, for surfaces.")
