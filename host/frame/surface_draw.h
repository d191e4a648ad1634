/// Draws renderers' surfaces and the caps of their parts into what a pass wants of them: layers, a transparency's store, ids.
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
  lumen::DepthDraw what = {};                       ///< which parts, and whether they are closed
};

/// Draws one surface into the bound framebuffer. Problems go to the renderer's reports.
void draw_surface(const FrameContext& context, const SceneSurface& surface, const SurfaceOutput& output);

}  // namespace lumenshop
