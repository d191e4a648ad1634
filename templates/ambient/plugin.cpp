/// Ambient light, brighter from above.

#include <lumen/term.h>

namespace {

struct @Class@ : lumen::Ambient {
  using Ambient::Ambient;

  lumen::Property<float> from_below{this, "from_below", 0.5f, {.min = 0, .max = 1, .doc = "how much of the light arrives from below"}};
};

}  // namespace

LUMEN_PLUGIN(@Class@, "ambient.@name@", "Ambient light, brighter from above.")
