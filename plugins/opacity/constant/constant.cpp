/// The same opacity everywhere.

#include <lumen/term.h>

namespace {

struct Constant : lumen::Opacity {
  using Opacity::Opacity;

  lumen::Property<float> alpha{this, "alpha", 0.4f, {.min = 0, .max = 1, .doc = "opacity; 0 shows nothing"}};
};

}  // namespace

LUMEN_PLUGIN(Constant, "opacity.constant", "The same opacity everywhere.")
