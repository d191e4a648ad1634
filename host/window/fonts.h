/// The window's fonts: Inter for words, JetBrains Mono for numbers, from the system; what is missing is replaced.
#pragma once

#include <lumen/ui/look.h>

namespace lumenshop {

/// Fills ImGui's atlas for the look's scale, with FreeType and light hinting, and the look's fonts.
void load_fonts(lumen::ui::Look& look);

}  // namespace lumenshop
