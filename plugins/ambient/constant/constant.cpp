/// Ambient light, the same from everywhere.

#include <lumen/term.h>

namespace {

struct Constant : lumen::Ambient {
  using Ambient::Ambient;

  lumen::Property<float> intensity{this, "intensity", 1.0f, {.min = 0, .max = 10, .doc = "ambient light that arrives everywhere"}};
};

}  // namespace

LUMEN_PLUGIN(Constant, "ambient.constant", "Ambient light, the same from everywhere.")
