#include <lumen/ui/simple_fields.h>

#include <algorithm>
#include <cfloat>
#include <utility>

#include <lumen/ui/icons.h>
#include <lumen/ui/look.h>
#include <lumen/ui/text_field.h>

namespace lumen::ui {
namespace {

Edit segments(std::string& name, std::span<const std::string> names, float width, const FieldStyle& style) {
  const Look& it = look();
  Edit edit;
  const float segment = width / static_cast<float>(names.size()), height = ImGui::GetFrameHeight();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImDrawList* list = ImGui::GetWindowDrawList();
  field_frame(corner, {corner.x + width, corner.y + height}, false, style);
  for (std::size_t index = 0; index < names.size(); ++index) {
    const ImVec2 min(corner.x + segment * static_cast<float>(index), corner.y), max(min.x + segment, min.y + height);
    ImGui::SetCursorScreenPos(min);
    ImGui::PushID(static_cast<int>(index));
    const bool pressed = ImGui::InvisibleButton("segment", {segment, height});
    ImGui::PopID();
    const bool chosen = names[index] == name;
    if (chosen || ImGui::IsItemHovered()) list->AddRectFilled(min, max, chosen ? it.colors.selection : it.colors.hover, it(3));
    const float text_width = ImGui::CalcTextSize(names[index].c_str()).x;
    text_elided(list, {min.x + std::max(it(3), (segment - text_width) / 2), min.y + (height - ImGui::GetFontSize()) / 2}, segment - it(4),
                names[index], faded(chosen ? it.colors.text : it.colors.label, style.dimmed ? 0.6f : 1));
    if (pressed && !chosen && !style.locked) {
      name = names[index];
      edit.changed = true;
    }
  }
  ImGui::SetCursorScreenPos(corner);
  ImGui::Dummy({width, height});
  return edit;
}

/// A row's buttons at the right: remove. True if it was pressed.
bool remove_button(float size) { return icon_button("remove", Icon::cross, size, look().colors.dim, "remove this entry"); }

template <class T, class Row>
Edit rows_of(const char* id, std::vector<T>& values, float width, T fresh, Row row) {
  constexpr std::size_t most_rows = 64;  // a longer list is edited through paste
  const Look& it = look();
  Edit edit;
  ImGui::PushID(id);
  ImGui::BeginGroup();
  const float button = ImGui::GetFrameHeight();
  int gone = -1;
  const std::size_t shown = std::min(values.size(), most_rows);
  for (std::size_t index = 0; index < shown; ++index) {
    ImGui::PushID(static_cast<int>(index));
    edit |= row(values[index], width - button - it(3));
    ImGui::SameLine(0, it(3));
    if (remove_button(button)) gone = static_cast<int>(index);
    ImGui::PopID();
  }
  if (shown < values.size()) text("and " + std::to_string(values.size() - shown) + " more", it.colors.dim);
  if (gone >= 0) {
    values.erase(values.begin() + gone);
    edit.changed = true;
  }
  if (icon_button("add", Icon::plus, button, it.colors.label, "add an entry")) {
    values.push_back(std::move(fresh));
    edit.changed = true;
  }
  ImGui::EndGroup();
  ImGui::PopID();
  return edit;
}

}  // namespace

Edit check_field(const char* id, bool& value, const FieldStyle& style) {
  const Look& it = look();
  Edit edit;
  const float size = ImGui::GetFrameHeight();
  const ImVec2 corner = ImGui::GetCursorScreenPos(), end(corner.x + size, corner.y + size);
  const bool pressed = ImGui::InvisibleButton(id, {size, size});
  field_frame(corner, end, ImGui::IsItemHovered(), style);
  if (value) draw_icon(ImGui::GetWindowDrawList(), Icon::check, {corner.x + it(4), corner.y + it(4)}, size - it(8), faded(it.colors.text, style.dimmed ? 0.55f : 1));
  if (!style.source.empty()) {
    const FontScope mono(it.mono);
    ImGui::SameLine(0, it(8));
    text(style.source, it.colors.driven);
  }
  if (pressed && !style.locked) {
    value = !value;
    edit.changed = true;
  }
  return edit;
}

Edit choice_field(const char* id, std::string& name, std::span<const std::string> names, float width, const FieldStyle& style) {
  const Look& it = look();
  Edit edit;
  ImGui::PushID(id);
  float widest = 0;
  for (const std::string& each : names) widest = std::max(widest, ImGui::CalcTextSize(each.c_str()).x);
  if (!names.empty() && names.size() <= 4 && (widest + it(8)) * static_cast<float>(names.size()) <= width) {
    edit = segments(name, names, width, style);
  } else {
    ImGui::SetNextItemWidth(width);
    if (ImGui::BeginCombo("list", name.c_str(), ImGuiComboFlags_HeightLarge)) {
      std::string& filter = look().filter;
      if (ImGui::IsWindowAppearing()) {
        filter.clear();
        ImGui::SetKeyboardFocusHere();
      }
      search_field("filter", filter, -FLT_MIN, "Filter");
      for (const std::string& each : names) {
        if (!matches(each, filter)) continue;
        if (ImGui::Selectable(each.c_str(), each == name) && !style.locked && each != name) {
          name = each;
          edit.changed = true;
        }
        if (each == name && ImGui::IsWindowAppearing()) ImGui::SetScrollHereY();
      }
      ImGui::EndCombo();
    }
  }
  ImGui::PopID();
  return edit;
}

Edit vector_field(const char* id, std::span<float> values, const NumberRange& range, float width, std::string_view prefixes, const FieldStyle& style) {
  const Look& it = look();
  Edit edit;
  ImGui::PushID(id);
  ImGui::BeginGroup();
  const bool stacked = width < it(200) && values.size() > 1;
  const float gap = it(3), count = static_cast<float>(values.size());
  const float each = stacked ? width : (width - gap * (count - 1)) / count;
  for (std::size_t index = 0; index < values.size(); ++index) {
    if (index > 0 && !stacked) ImGui::SameLine(0, gap);
    FieldStyle part = style;
    if (part.source.empty() && index < prefixes.size()) part.prefix = prefixes.substr(index, 1);
    if (!stacked && index + 1 < values.size()) part.unit = {};
    ImGui::PushID(static_cast<int>(index));
    edit |= number_field("component", values[index], range, each, part);
    ImGui::PopID();
  }
  ImGui::EndGroup();
  ImGui::PopID();
  return edit;
}

Edit string_field(const char* id, std::string& value, float width, bool failed) {
  const Look& it = look();
  Edit edit;
  edit.changed = text_field(id, value, width);
  if (failed) ImGui::GetWindowDrawList()->AddRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), it.colors.error, it(3), 0, it(1.5f));
  return edit;
}

Edit path_field(const char* id, std::string& file, float width, bool failed) {
  const Look& it = look();
  Edit edit;
  ImGui::BeginGroup();
  const float button = ImGui::GetFrameHeight();
  edit.changed = text_field(id, file, width - button - it(3), "a file", true);
  if (failed) ImGui::GetWindowDrawList()->AddRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), it.colors.error, it(3), 0, it(1.5f));
  ImGui::SameLine(0, it(3));
  ImGui::PushID(id);
  if (icon_button("browse", Icon::folder, button, it.colors.label, "choose a file") && it.browse) {
    look().browse_for = ImGui::GetID("chosen");
    it.browse(file);
  }
  const ImGuiID answer = ImGui::GetID("chosen");
  ImGui::PopID();
  ImGui::EndGroup();
  if (it.browse_for == answer && !it.browsed.empty()) {
    file = std::exchange(look().browsed, {});
    look().browse_for = 0;
    edit.changed = true;
  }
  return edit;
}

Edit list_field(const char* id, std::vector<int>& values, const NumberRange& range, float width) {
  return rows_of<int>(id, values, width, 0, [&](int& value, float room) { return number_field("value", value, range, room); });
}

Edit list_field(const char* id, std::vector<float>& values, const NumberRange& range, float width) {
  return rows_of<float>(id, values, width, 0.0f, [&](float& value, float room) { return number_field("value", value, range, room); });
}

Edit list_field(const char* id, std::vector<std::string>& values, float width) {
  return rows_of<std::string>(id, values, width, {}, [](std::string& value, float room) {
    Edit edit;
    edit.changed = text_field("value", value, room);
    return edit;
  });
}

}  // namespace lumen::ui
