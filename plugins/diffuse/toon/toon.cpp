/// Diffuse light in four flat bands. Lake et al., Stylized Rendering Techniques for Scalable Real-Time 3D Animation, NPAR 2000; levels of Ostendorf 2021, eq. 3.8.

#include <lumen/term.h>

namespace {

struct Toon : lumen::Diffuse {
  using Diffuse::Diffuse;

  lumen::Property<glm::vec3> thresholds{this, "thresholds", glm::vec3(0.95f, 0.5f, 0.25f), {.min = 0, .max = 1, .doc = "N.L from which each of the three upper bands begins, brightest first"}};
  lumen::Property<glm::vec4> levels{this, "levels", glm::vec4(0.8f, 0.5f, 0.25f, 0.1f), {.min = 0, .max = 1, .doc = "light of the bands, brightest first; where no light arrives it is 0"}};
  lumen::Property<bool> as_printed{this, "as_printed", false, {.doc = "multiplies each band by N.L, as eq. 3.10 of the source does, so that the bands keep gradients"}};
};

}  // namespace

LUMEN_PLUGIN(Toon, "diffuse.toon", "Diffuse light in four flat bands. Lake et al., Stylized Rendering Techniques for Scalable Real-Time 3D Animation, NPAR 2000; levels of Ostendorf 2021, eq. 3.8.")
