/// Icons as strokes: the fonts lack the glyphs.
#pragma once

#include <imgui.h>

namespace lumen::ui {

enum class Icon {
  none, dot, chain, function, triangle, question, check, eye, eye_off, chevron_right, chevron_down,
  cross, refresh, plus, square, diamond, play, disc, screen, up, down, folder, file
};

/// Draws it centered in a square of `size` pixels at `corner`.
void draw_icon(ImDrawList* list, Icon icon, ImVec2 corner, float size, ImU32 color);

/// A button without a frame, `size` pixels square; its tooltip says what it does. Keyed by `id`.
bool icon_button(const char* id, Icon icon, float size, ImU32 color, const char* tooltip);

}  // namespace lumen::ui
