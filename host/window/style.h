/// ImGui's style from the look: its colors and sizes.
#pragma once

#include <lumen/ui/look.h>

namespace lumenshop {

void apply_imgui_style(const lumen::ui::Look& look);

}  // namespace lumenshop
