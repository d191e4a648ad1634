/// Opacity that falls off with the distance to the eye.

#include <lumen/term.h>

namespace {

struct @Class@ : lumen::Opacity {
  using Opacity::Opacity;

  lumen::Property<float> alpha{this, "alpha", 0.5f, {.min = 0, .max = 1, .doc = "opacity at the near end of the scene"}};
  lumen::Property<float> far_part{this, "far_part", 1.0f, {.min = 0, .max = 1, .doc = "what is left of it at the far end"}};
};

}  // namespace

LUMEN_PLUGIN(@Class@, "opacity.@name@", "Opacity that falls off with the distance to the eye.")
