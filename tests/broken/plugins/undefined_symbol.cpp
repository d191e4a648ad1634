/// Needs a function that nobody has.
#include <lumen/term.h>

extern "C" [[gnu::visibility("default")]] int function_that_nobody_has();

namespace {

struct UndefinedSymbol : lumen::Ambient {
  using Ambient::Ambient;
  int number = function_that_nobody_has();
};

}  // namespace

LUMEN_PLUGIN(UndefinedSymbol, "ambient.undefined_symbol", "Needs a function that nobody has.")
