#include <lumen/ui/number_field.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <imgui_internal.h>

#include <lumen/ui/look.h>
#include <lumen/ui/text_field.h>

namespace lumen::ui {
namespace {

constexpr float click_radius = 3;  // UI units that a click may move

/// Follows the pointer while the button is down.
Edit follow(ImGuiID item, double& value, const NumberRange& range) {
  Look& it = look();
  const ImGuiIO& io = ImGui::GetIO();
  Edit edit;
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false) || ImGui::IsMouseClicked(1)) {
    it.swallow_right = true;
    edit.cancelled = it.drag.moving;
    value = it.drag.start;
    it.drag = {};
    ImGui::ClearActiveID();
    return edit;
  }
  if (!it.drag.moving && std::abs(ImGui::GetMouseDragDelta(0, 0).x) >= it(click_radius)) {
    it.drag.moving = true;
    it.drag.travel = 0;
  }
  if (it.drag.moving) {
    edit.active = true;
    it.drag.travel += io.MouseDelta.x / it.scale * (io.KeyShift ? 0.1 : 1.0);
    const double next = dragged(range, it.drag.start, it.drag.travel, io.KeyCtrl);
    edit.changed = next != value;
    value = next;
  }
  if (!io.MouseDown[0]) {
    if (!it.drag.moving) begin_typing(item, written_fully(value, range.integer));
    it.drag = {};
    ImGui::ClearActiveID();
  }
  return edit;
}

void draw_value(ImVec2 min, ImVec2 max, double value, const NumberRange& range, const FieldStyle& style) {
  const Look& it = look();
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float fade = style.dimmed ? 0.55f : 1;
  const FontScope mono(it.mono);
  const float padding = it(8), top = min.y + (max.y - min.y - ImGui::GetFontSize()) / 2;
  float right = max.x - padding;
  const auto width_of = [](std::string_view words) { return ImGui::CalcTextSize(words.data(), words.data() + words.size()).x; };
  const std::string number = written(value, range.integer);
  const float number_width = width_of(number);
  const bool narrow = max.x - min.x < it(110);
  if (!style.unit.empty() && !narrow) {
    right -= width_of(style.unit);
    list->AddText({right, top}, faded(it.colors.dim, fade), style.unit.data(), style.unit.data() + style.unit.size());
    right -= it(8);
  }
  const float left = std::max(min.x + it(3), right - number_width);
  list->PushClipRect(min, max, true);
  list->AddText({left, top}, faded(it.colors.text, fade), number.c_str());
  list->PopClipRect();
  const float room = left - min.x - 2 * padding;
  if (!style.source.empty()) text_elided(list, {min.x + padding, top}, room, style.source, faded(it.colors.driven, fade));
  else if (!style.prefix.empty() && room > 0) text_elided(list, {min.x + it(5), top}, left - min.x - it(7), style.prefix, faded(it.colors.dim, fade));

  if (const auto place = place_of(range, value)) {
    const float inset = it(2), height = std::max(1.0f, std::round(it(2)));
    const float end = min.x + inset + static_cast<float>(*place) * (max.x - min.x - 2 * inset);
    const ImU32 color = style.source.empty() ? it.colors.label : it.colors.driven;
    list->AddRectFilled({min.x + inset, max.y - height - 1}, {end, max.y - 1}, faded(color, fade));
  }
}

template <class T>
Edit narrow_field(const char* id, T& value, const NumberRange& range, float width, const FieldStyle& style) {
  using Limits = std::numeric_limits<T>;
  double number = value;
  const Edit edit = number_field(id, number, range, width, style);
  if (edit.changed) value = static_cast<T>(std::clamp(number, double(Limits::lowest()), double(Limits::max())));
  return edit;
}

}  // namespace

void field_frame(ImVec2 min, ImVec2 max, bool hovered, const FieldStyle& style) {
  const Look& it = look();
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(min, max, faded(hovered && !style.locked ? it.colors.hover : it.colors.field, style.dimmed ? 0.6f : 1), it(3));
  if (style.failed) list->AddRect(min, max, it.colors.error, it(3), 0, std::max(1.0f, it(1.5f)));
  else if (it.colors.bordered) list->AddRect(min, max, it.colors.border, it(3));
}

Edit number_field(const char* id, double& value, const NumberRange& range, float width, const FieldStyle& style) {
  Look& it = look();
  ImGuiWindow* window = ImGui::GetCurrentWindow();
  Edit edit;
  if (window->SkipItems) return edit;
  const ImGuiID item = window->GetID(id);
  const ImRect box(window->DC.CursorPos, {window->DC.CursorPos.x + width, window->DC.CursorPos.y + ImGui::GetFrameHeight()});
  ImGui::ItemSize(box.GetSize(), ImGui::GetStyle().FramePadding.y);
  if (!ImGui::ItemAdd(box, item, nullptr, style.locked ? ImGuiItemFlags_None : ImGuiItemFlags_Inputable)) return edit;
  const bool hovered = ImGui::ItemHoverable(box, item);

  if (is_typing(item)) {
    const FontScope mono(it.mono);
    std::string text;
    if (type_over(id, box.Min, box.Max, text)) {
      if (const auto typed = calculated(text)) {
        value = range.integer ? std::round(*typed) : *typed;
        value = std::clamp(value, range.min, std::max(range.min, range.max));
        edit.changed = true;
      } else {
        it.notice = "'" + text + "' is no number; type one, or arithmetic such as 2*(1+0.5)";
      }
    }
    return edit;
  }

  const bool tabbed = (ImGui::GetItemStatusFlags() & ImGuiItemStatusFlags_FocusedByTabbing) != 0;
  const ImGuiIO& io = ImGui::GetIO();
  if (!style.locked && (tabbed || (hovered && io.KeyCtrl && io.MouseClicked[0]))) {
    begin_typing(item, written_fully(value, range.integer));
  } else if (!style.locked && hovered && io.MouseClicked[0]) {
    ImGui::SetActiveID(item, window);
    ImGui::SetFocusID(item, window);
    ImGui::FocusWindow(window);
    it.drag = {item, value, 0, false};
  }
  if (ImGui::GetActiveID() == item && it.drag.field == item) edit |= follow(item, value, range);
  if (!style.locked && hovered && io.KeyCtrl) {
    ImGui::SetItemUsingMouseWheel();
    if (io.MouseWheel != 0) {
      const double next = stepped(range, value, io.MouseWheel * (io.KeyShift ? 0.1 : 1.0));
      edit.changed = edit.nudged = next != value;
      value = next;
    }
  }
  if (hovered && !style.locked) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  field_frame(box.Min, box.Max, hovered || ImGui::GetActiveID() == item, style);
  if (is_typing(item)) {
    std::string ignored;
    const FontScope mono(it.mono);
    type_over(id, box.Min, box.Max, ignored);
  } else {
    draw_value(box.Min, box.Max, value, range, style);
  }
  return edit;
}

Edit number_field(const char* id, float& value, const NumberRange& range, float width, const FieldStyle& style) {
  return narrow_field(id, value, range, width, style);
}

Edit number_field(const char* id, int& value, const NumberRange& range, float width, const FieldStyle& style) {
  return narrow_field(id, value, range, width, style);
}

}  // namespace lumen::ui
