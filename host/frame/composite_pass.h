/// Small steps between passes: merging the transparent color, and the running mean of a pixel's samples.
#pragma once

#include <string>

#include "frame/frame_context.h"

namespace lumenshop {

/// `merged` = `transparent` over `lit`, in the context's layers. Runs if due.
void run_merge_pass(const FrameContext& context);

/// Layer `sum` of `sums` becomes the mean of its `count` samples and one more, `source`.
void accumulate(const FrameContext& context, const lumen::gl::Texture& source, LayerStore& sums, const std::string& sum, int count);

}  // namespace lumenshop
