/// Light that diffuses under a bent surface: a soft terminator that reddens, and light from behind that shines through. Diffusion around a ring in closed form, looked up by N.L as in Penner, Pre-Integrated Skin Shading, SIGGRAPH 2011 courses; light from behind after Barre-Brisebois, Bouchard, GDC 2011.

#include <lumen/term.h>

namespace {

struct Subsurface : lumen::Diffuse {
  using Diffuse::Diffuse;

  lumen::Property<float> width{this, "width", 0.3f, {.min = 0, .max = 3, .unit = "radians", .doc = "how far light diffuses, over the radius of curvature of the surface, such as a vessel's; 0 is Lambert"}};
  lumen::Property<lumen::Color> spread{this, "spread", lumen::Color(1, 0.35f, 0.2f), {.min = 0, .max = 1, .doc = "how far red, green and blue light diffuse, as shares of the width"}};
  lumen::Property<float> through{this, "through", 0.3f, {.min = 0, .max = 4, .doc = "light from behind that arrives, colored by the spread"}};
  lumen::Property<float> distortion{this, "distortion", 0.3f, {.min = 0, .max = 1, .doc = "how much the surface's normal bends the light that shines through"}};
  lumen::Property<float> sharpness{this, "sharpness", 4.0f, {.min = 0.5, .max = 50, .doc = "how narrowly light shines through straight on", .logarithmic = true}};
};

}  // namespace

LUMEN_PLUGIN(Subsurface, "diffuse.subsurface", "Light that diffuses under a bent surface: a soft terminator that reddens, and light from behind that shines through. Diffusion around a ring in closed form, looked up by N.L as in Penner, Pre-Integrated Skin Shading, SIGGRAPH 2011 courses; light from behind after Barre-Brisebois, Bouchard, GDC 2011.")
