/// The programs that draw surfaces: a renderer's shader between what cuts it before and what a pass makes of it after.
#pragma once

#include <span>
#include <string>
#include <utility>

#include <lumen/gl/texture.h>

#include "frame/frame_context.h"
#include "frame/program_text.h"

namespace lumenshop {

/// What a program of a part is made for.
struct SurfaceProgram {
  int planes = 0;          ///< that cut the part
  bool removes = false;    ///< the splitters' removed() is asked
  bool inside = false;     ///< the inside has a look of its own
  bool cut_face = false;   ///< which is that of the cut's face
  bool cap = false;        ///< draws a cap, not the renderer's surface
};

/// Adds all up to Surface lumen_surface(), which the fragment's main() calls. `file`: the renderer's shader, which a cap does
/// not use.
void write_surface_text(ProgramText& vertex, ProgramText& fragment, const SceneSurface& surface, const std::string& file,
                        std::span<const std::pair<const char*, const lumen::gl::Texture*>> inputs, const SurfaceProgram& program);

/// Differs where the text of the splitters' functions does.
std::uint64_t splitters_signature(const SceneSurface& surface);
/// Makes what the splitters' functions read current.
void bind_splitters(const FrameContext& context, const SceneSurface& surface, Program& program);

}  // namespace lumenshop
