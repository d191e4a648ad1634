/// Text: one line that takes effect when the person has finished.
#pragma once

#include <string>
#include <string_view>

#include <imgui.h>

namespace lumen::ui {

/// True when a changed text was finished (Enter, Tab, a click elsewhere); Esc keeps the old one. Width in pixels.
bool text_field(const char* id, std::string& text, float width, const char* hint = "", bool mono = false);

/// A filter: takes effect with every letter; a cross empties it.
bool search_field(const char* id, std::string& text, float width, const char* hint);

/// Whether `text` has all words of the filter, whatever their case and order.
bool matches(std::string_view text, std::string_view filter);

/// Types over a control's rectangle, starting with `initial` selected. Begins at begin_typing (`item` = ImGui's id of the
/// control); type_over, with the control's own `id`, is true once when a changed text was finished, which is then in `text`.
void begin_typing(ImGuiID item, const std::string& initial);
bool is_typing(ImGuiID item);
bool type_over(const char* id, ImVec2 min, ImVec2 max, std::string& text);

}  // namespace lumen::ui
