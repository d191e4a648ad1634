/// The opaque scene as layers.
#pragma once

#include "frame/frame_context.h"

namespace lumenshop {

/// The opaque scene: layers depth, normal, `albedo` and `id` if wanted, and the depth buffer `depth_buffer`. Runs if due.
struct GeometryLayers {
  bool albedo = false, id = false;
};
void run_geometry_pass(const FrameContext& context, GeometryLayers wanted);

/// What depends on the surfaces' shape and place, as one number.
std::uint64_t surfaces_key(const FrameContext& context, const std::vector<SceneSurface>& surfaces);

}  // namespace lumenshop
