/// The opaque surfaces from another camera than the view's.
#pragma once

#include "frame/frame_context.h"

namespace lumenshop {

/// Fills `depth` (R32F, any size) with eye distances along the camera's axis; +inf where there is nothing.
void draw_depth(const FrameContext& context, const lumen::Camera& camera, const lumen::gl::Texture& depth);

}  // namespace lumenshop
