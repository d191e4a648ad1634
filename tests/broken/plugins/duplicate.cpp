/// Another library with a type of sound.cpp.
#include <lumen/term.h>

namespace {

struct Duplicate : lumen::Ambient {
  using Ambient::Ambient;
};

}  // namespace

LUMEN_PLUGIN(Duplicate, "ambient.sound", "The same id in another library.")
