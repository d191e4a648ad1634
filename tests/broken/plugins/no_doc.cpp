/// Says nothing about itself.
#include <lumen/term.h>

namespace {

struct NoDoc : lumen::Ambient {
  using Ambient::Ambient;
};

}  // namespace

LUMEN_PLUGIN(NoDoc, "ambient.no_doc", "")
