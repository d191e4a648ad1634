/// The colors of the window: one table. Hue means a state, and always comes with a glyph and a word.
#pragma once

#include <imgui.h>

namespace lumen::ui {

enum class Theme { dark, light, high_contrast };

struct Palette {
  ImU32 canvas, panel, field, hover;        ///< behind pictures; panels; fields; what the pointer is on
  ImU32 text, label, dim;                   ///< values; names; what is secondary
  ImU32 driven, done, warning, error;       ///< links; success; caution; failure
  ImU32 border, selection, focus;
  bool bordered;                            ///< fields have a border of their own
};

const Palette& palette(Theme theme);

/// Contrast of two opaque colors as WCAG 2 has it, 1..21.
float contrast(ImU32 one, ImU32 other);

/// `color` with its opacity times `factor`.
ImU32 faded(ImU32 color, float factor);

}  // namespace lumen::ui
