/// One full-screen pass lights all opaque surfaces: `lit` (radiance, alpha 1 where covered), and parts of it if wanted.
#pragma once

#include "frame/frame_context.h"

namespace lumenshop {

enum class LightingOutput {
  lit,
  summands,   ///< also ambient, diffuse, specular
  apart,      ///< `lit` lacks what the occlusion attenuates; that is in `open`, as it is without the occlusion
};
/// Reads depth, normal, albedo and, unless apart, what the view's occlusion wrote. Runs if due.
void run_lighting_pass(const FrameContext& context, LightingOutput output);

/// What the view's occlusion wrote and what it multiplies.
struct Visibility {
  lumen::Attenuates attenuates = lumen::Attenuates::ambient;
  std::string layer;   ///< "occlusion", "illumination" or empty
};
Visibility visibility_of(const FrameContext& context);

}  // namespace lumenshop
