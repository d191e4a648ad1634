/// Its id says another kind than its class.
#include <lumen/term.h>

namespace {

struct WrongKind : lumen::Ambient {
  using Ambient::Ambient;
};

}  // namespace

LUMEN_PLUGIN(WrongKind, "diffuse.wrong_kind", "An ambient term that says it is a diffuse one.")
