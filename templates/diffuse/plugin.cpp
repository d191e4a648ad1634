/// Diffuse light in steps. Lake, Marshall, Harris, Blackstein, NPAR 2000.

#include <lumen/term.h>

namespace {

struct @Class@ : lumen::Diffuse {
  using Diffuse::Diffuse;

  lumen::Property<int> steps{this, "steps", 4, {.min = 1, .max = 32, .doc = "levels between dark and lit"}};
};

}  // namespace

LUMEN_PLUGIN(@Class@, "diffuse.@name@", "Diffuse light in steps. Lake et al., NPAR 2000.")
