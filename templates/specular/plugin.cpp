/// Highlights of the mirrored light. Phong, Illumination for Computer Generated Pictures, CACM 1975.

#include <lumen/term.h>

namespace {

struct @Class@ : lumen::Specular {
  using Specular::Specular;

  lumen::Property<float> strength{this, "strength", 1.0f, {.min = 0, .max = 4, .doc = "multiplies the highlight"}};
};

}  // namespace

LUMEN_PLUGIN(@Class@, "specular.@name@", "Highlights of the mirrored light. Phong, CACM 1975.")
