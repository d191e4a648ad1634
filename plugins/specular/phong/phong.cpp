/// Highlights around the mirrored light, max(0, R.V)^shininess. Phong, Illumination for Computer Generated Pictures, CACM 1975.

#include <lumen/term.h>

namespace {

struct Phong : lumen::Specular {
  using Specular::Specular;
};

}  // namespace

LUMEN_PLUGIN(Phong, "specular.phong", "Highlights around the mirrored light, max(0, R.V)^shininess. Phong, Illumination for Computer Generated Pictures, CACM 1975.")
