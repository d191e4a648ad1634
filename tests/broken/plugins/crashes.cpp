/// Its constructor writes to null.
#include <lumen/term.h>

namespace {

struct Crashes : lumen::Ambient {
  explicit Crashes(lumen::Binding& binding) : Ambient(binding) { *nowhere = 1; }
  int* volatile nowhere = nullptr;
};

}  // namespace

LUMEN_PLUGIN(Crashes, "ambient.crashes", "Crashes in its constructor.")
