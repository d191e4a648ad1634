/// Which pixels of a picture of another size the opaque scene covers, as a depth buffer.
#pragma once

#include <string>

#include "frame/frame_context.h"

namespace lumenshop {

/// The layer `depth_buffer` at `size`, from the pixels at the centers of its texels; kept as the layer `name` and made anew when due.
/// Null if there is no such depth buffer.
const lumen::gl::Texture* coverage(const FrameContext& context, const std::string& depth_buffer, glm::ivec2 size, const std::string& name);

}  // namespace lumenshop
