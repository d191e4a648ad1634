/// Highlights around the halfway vector, max(0, N.H)^shininess. Blinn, Models of Light Reflection for Computer Synthesized Pictures, SIGGRAPH 1977.

#include <lumen/term.h>

namespace {

struct Blinn : lumen::Specular {
  using Specular::Specular;
};

}  // namespace

LUMEN_PLUGIN(Blinn, "specular.blinn", "Highlights around the halfway vector, max(0, N.H)^shininess. Blinn, Models of Light Reflection for Computer Synthesized Pictures, SIGGRAPH 1977.")
