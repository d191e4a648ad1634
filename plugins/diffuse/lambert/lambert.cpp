/// Ideal diffuse reflection, max(0, N.L). Lambert, Photometria, 1760.

#include <lumen/term.h>

namespace {

struct Lambert : lumen::Diffuse {
  using Diffuse::Diffuse;
};

}  // namespace

LUMEN_PLUGIN(Lambert, "diffuse.lambert", "Ideal diffuse reflection, max(0, N.L). Lambert, Photometria, 1760.")
