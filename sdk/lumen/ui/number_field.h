/// A number: dragged, typed, or stepped by Ctrl + wheel.
#pragma once

#include <string_view>

#include <imgui.h>

#include <lumen/ui/edit.h>
#include <lumen/ui/number.h>

namespace lumen::ui {

/// How a field looks beside its value.
struct FieldStyle {
  std::string_view unit = {};     ///< dim, behind the value
  std::string_view source = {};   ///< what drives it: shown left, in the driven color
  std::string_view prefix = {};   ///< "x", "R": dim, left
  bool dimmed = false;            ///< has no effect
  bool failed = false;            ///< error border
  bool locked = false;            ///< shows, does not take
};

/// Draws a field's background in the state of the last item; for controls of one's own.
void field_frame(ImVec2 min, ImVec2 max, bool hovered, const FieldStyle& style);

/// `width` pixels wide, one row high.
Edit number_field(const char* id, double& value, const NumberRange& range, float width, const FieldStyle& style = {});
/// What is typed beyond the type becomes its nearest value.
Edit number_field(const char* id, float& value, const NumberRange& range, float width, const FieldStyle& style = {});
Edit number_field(const char* id, int& value, const NumberRange& range, float width, const FieldStyle& style = {});

}  // namespace lumen::ui
