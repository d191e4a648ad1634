/// Crashes while it is loaded.
#include <lumen/term.h>

namespace {

int* volatile nowhere = nullptr;
const int value = *nowhere = 1;

struct CrashesAtLoad : lumen::Ambient {
  using Ambient::Ambient;
  int number = value;
};

}  // namespace

LUMEN_PLUGIN(CrashesAtLoad, "ambient.crashes_at_load", "Crashes in a static initializer.")
