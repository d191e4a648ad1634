/// Its constructor never ends.
#include <lumen/term.h>

namespace {

struct Loops : lumen::Ambient {
  explicit Loops(lumen::Binding& binding) : Ambient(binding) {
    while (going) {
    }
  }
  volatile bool going = true;
};

}  // namespace

LUMEN_PLUGIN(Loops, "ambient.loops", "Does not come back from its constructor.")
