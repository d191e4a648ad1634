/// Draws renderers' surfaces into what a pass wants of them: layers, a transparency's store, ids.
#pragma once

#include <functional>
#include <string>

#include <lumen/frame.h>

#include "frame/frame_context.h"

namespace lumenshop {

/// What becomes of each fragment.
struct SurfaceOutput {
  std::string name;                                 ///< of the use: "geometry", "pick", "weighted store"
  std::uint64_t signature = 0;                      ///< differs where `write` writes something else
  /// Adds declarations and `void main()`; Surface lumen_surface() is there. `renderer` is the one being drawn.
  std::function<void(ProgramText&, const Instance& renderer)> write;
  std::function<void(Program&)> prepare = {};       ///< binds what `write` declared
  bool front_suffices = false;                      ///< what faces away or lies behind cannot be seen
  bool identifies = false;                          ///< primitives' numbers are wanted
};

/// Draws one surface into the bound framebuffer. Problems go to the renderer's reports.
void draw_surface(const FrameContext& context, const SceneSurface& surface, const SurfaceOutput& output);

/// The opaque scene: layers depth, normal, `albedo` and `id` if wanted, and the depth buffer `depth_buffer`. Runs if due.
struct GeometryLayers {
  bool albedo = false, id = false;
};
void run_geometry_pass(const FrameContext& context, GeometryLayers wanted);

/// What depends on the surfaces' shape and place, as one number.
std::uint64_t surfaces_key(const FrameContext& context, const std::vector<SceneSurface>& surfaces);

}  // namespace lumenshop
