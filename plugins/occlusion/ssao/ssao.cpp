/// Ambient occlusion from a hemisphere of samples around the normal, compared with the stored depth.
/// Mittring, Finding Next Gen: CryEngine 2, SIGGRAPH 2007 courses; the hemisphere after Ostendorf 2021, section 3.7.

#include "../hemisphere.h"

namespace {

struct Ssao : HemisphereOcclusion {
  explicit Ssao(lumen::Binding& binding) : HemisphereOcclusion(binding, "occlusion/ssao.glsl", {.common = {.radius = 0.05f, .refinements = 1}}) {}
};

}  // namespace

LUMEN_PLUGIN(Ssao, "occlusion.ssao", "Ambient occlusion from a hemisphere of samples. Mittring, Finding Next Gen: CryEngine 2, SIGGRAPH 2007 courses.")
