/// Says that it was built for another SDK.
#include <lumen/abi.h>
#undef LUMEN_ABI
#define LUMEN_ABI "another"
#include <lumen/term.h>

namespace {

struct OtherAbi : lumen::Ambient {
  using Ambient::Ambient;
};

}  // namespace

LUMEN_PLUGIN(OtherAbi, "ambient.other_abi", "Built for another SDK.")
