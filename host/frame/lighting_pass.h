/// One full-screen pass lights all opaque surfaces: `lit` (radiance, alpha 1 where covered), and its summands if wanted.
#pragma once

#include "frame/frame_context.h"

namespace lumenshop {

/// Reads depth, normal, albedo and what the view's occlusion wrote. Runs if due. `summands`: also ambient, diffuse, specular.
void run_lighting_pass(const FrameContext& context, bool summands);

/// What the view's occlusion wrote and what it multiplies.
struct Visibility {
  lumen::Attenuates attenuates = lumen::Attenuates::ambient;
  std::string layer;   ///< "occlusion", "illumination" or empty
};
Visibility visibility_of(const FrameContext& context);

}  // namespace lumenshop
