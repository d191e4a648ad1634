/// Says its last words on stderr.
#include <cstdio>
#include <cstdlib>

#include <lumen/term.h>

namespace {

struct PrintsAndAborts : lumen::Ambient {
  explicit PrintsAndAborts(lumen::Binding& binding) : Ambient(binding) {
    std::puts("rubbish on the standard output");
    std::fputs("first line\nthe vessel has no wall\n", stderr);
    std::abort();
  }
};

}  // namespace

LUMEN_PLUGIN(PrintsAndAborts, "ambient.prints_and_aborts", "Aborts with a message.")
