/// Its constructor throws.
#include <lumen/term.h>

namespace {

struct Throws : lumen::Ambient {
  explicit Throws(lumen::Binding& binding) : Ambient(binding) { throw lumen::Error("it does not want to"); }
};

}  // namespace

LUMEN_PLUGIN(Throws, "ambient.throws", "Throws in its constructor.")
