/// Occlusion of transparent surfaces: the front-most layers of them as if they were opaque, each seen by the view's
/// occlusion technique on its own, and what a fragment's shading takes from that.
#pragma once

#include <string>

#include "frame/plugin_pass.h"

namespace lumenshop {

/// Draws the layers and runs the occlusion over each, as far as due. `memories`: of the view's plugin passes. `front`:
/// somebody reads the front layer itself.
void run_transparent_layers(const FrameContext& context, std::map<std::string, PluginPassMemory>& memories, bool front);

/// Where compositors find the layers `front_depth`, `front_normal` and `opaque`.
LayerNames front_layers(const LayerStore& layers);

/// How many layers there are in this frame.
int transparent_occlusion_layers(const FrameContext& context);
/// Grows whenever the occlusion of any layer changes.
std::uint64_t transparent_occlusion_revision(const FrameContext& context);
/// GLSL of `vec3 lumen_visibility_of(Surface s)` for a fragment of a transparent surface.
std::string transparent_visibility_text(const FrameContext& context);
void bind_transparent_occlusion(const FrameContext& context, Program& program);

}  // namespace lumenshop
