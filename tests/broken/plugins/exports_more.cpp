/// Exports a function beside its table.
#include <lumen/term.h>

namespace {

struct ExportsMore : lumen::Ambient {
  using Ambient::Ambient;
};

}  // namespace

extern "C" [[gnu::visibility("default")]] int surplus() { return 1; }

LUMEN_PLUGIN(ExportsMore, "ambient.exports_more", "Exports a function beside its table.")
