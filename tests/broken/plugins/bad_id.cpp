/// Its kind does not exist.
#include <lumen/term.h>

namespace {

struct BadId : lumen::Ambient {
  using Ambient::Ambient;
};

}  // namespace

LUMEN_PLUGIN(BadId, "shading.bad_id", "Its kind does not exist.")
