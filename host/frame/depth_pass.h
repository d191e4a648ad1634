/// The opaque surfaces from another camera than the view's.
#pragma once

#include "frame/frame_context.h"

namespace lumenshop {

/// See lumen::Frame::draw_depth.
void draw_depth(const FrameContext& context, const lumen::Camera& camera, const lumen::gl::Texture& depth, const lumen::DepthDraw& what);

}  // namespace lumenshop
