/// Small steps between passes: merging the transparent color, and the mean of a pixel's samples.
#pragma once

#include <string>

#include "frame/frame_context.h"

namespace lumenshop {

/// `merged` = `transparent` over `lit`, in the context's layers. Runs if due.
void run_merge_pass(const FrameContext& context);

/// The pixels of `mean` become the mean of `rounds` rounds of samples, which they hold, and one more: 2 x 2 pixels of `source`, inside its border.
void add_to_mean(const FrameContext& context, const lumen::gl::Texture& source, const lumen::gl::Texture& mean, const PixelBox& pixels, int rounds);

/// Layers depth, normal and `depth_buffer` of `centers` take the lower left of the 2 x 2 samples of each pixel.
void pick_samples(const FrameContext& context, LayerStore& centers, const PixelBox& pixels);

/// Adds what the occlusion leaves of the radiance `open`, which holds `pixels` alone, to `sum`.
void add_attenuated(const FrameContext& context, const lumen::gl::Texture& open, const std::string& occlusion_layer, const lumen::gl::Texture& sum,
                    const PixelBox& pixels);

}  // namespace lumenshop
