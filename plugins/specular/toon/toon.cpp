/// Highlights with a hard edge. Lake et al., Stylized Rendering Techniques for Scalable Real-Time 3D Animation, NPAR 2000; Ostendorf 2021, eq. 3.9 with N.H.

#include <lumen/term.h>

namespace {

struct Toon : lumen::Specular {
  using Specular::Specular;

  lumen::Property<float> threshold{this, "threshold", 0.99f, {.min = 0, .max = 1, .doc = "N.H above which the highlight is full"}};
};

}  // namespace

LUMEN_PLUGIN(Toon, "specular.toon", "Highlights with a hard edge. Lake et al., Stylized Rendering Techniques for Scalable Real-Time 3D Animation, NPAR 2000; Ostendorf 2021, eq. 3.9 with N.H.")
