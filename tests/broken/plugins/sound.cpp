/// A library with nothing wrong, for comparison.
#include <lumen/term.h>

namespace {

struct Sound : lumen::Ambient {
  using Ambient::Ambient;
  lumen::Property<float> strength{this, "strength", 0.5f, {.min = 0, .max = 1, .doc = "how much"}};
  lumen::Property<lumen::Choice> mode{this, "mode", {"soft"}, {.doc = "which way", .choices = {"soft", "hard"}}};
};

}  // namespace

LUMEN_PLUGIN(Sound, "ambient.sound", "Nothing is wrong with it.")
