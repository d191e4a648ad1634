#include <lumen/ui/text_field.h>

#include <algorithm>
#include <cctype>

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <lumen/ui/icons.h>
#include <lumen/ui/look.h>

namespace lumen::ui {
namespace {

constexpr std::size_t typed_limit = 512;

/// Takes the finished text out, if it differs from what was there and its field did not vanish meanwhile.
bool finish(ImGuiID item, std::string& text) {
  Look& it = look();
  const auto found = it.typing.find(item);
  if (found == it.typing.end()) return false;
  const Typing typing = std::move(found->second);
  it.typing.erase(found);
  if (typing.frame < ImGui::GetFrameCount() - 1 || typing.text == typing.before) return false;
  text = typing.text;
  return true;
}

}  // namespace

bool text_field(const char* id, std::string& text, float width, const char* hint, bool mono) {
  Look& it = look();
  const FontScope font(mono ? it.mono : nullptr);
  const ImGuiID item = ImGui::GetID(id);
  const auto found = it.typing.find(item);
  std::string shown = text;
  std::string& buffer = found == it.typing.end() ? shown : found->second.text;
  ImGui::SetNextItemWidth(width);
  ImGui::InputTextWithHint(id, hint, &buffer);
  if (ImGui::IsItemActive()) {
    if (found == it.typing.end()) it.typing[item] = {shown, text, ImGui::GetFrameCount(), true};
    else found->second.frame = ImGui::GetFrameCount();
    return false;
  }
  return finish(item, text);
}

bool search_field(const char* id, std::string& text, float width, const char* hint) {
  const Look& it = look();
  ImGui::SetNextItemWidth(width);
  bool changed = ImGui::InputTextWithHint((std::string("##") + id).c_str(), hint, &text);
  record(id);
  if (text.empty()) return changed;
  const ImVec2 max = ImGui::GetItemRectMax(), next = ImGui::GetCursorScreenPos();
  const float size = max.y - ImGui::GetItemRectMin().y;
  ImGui::SetItemAllowOverlap();
  ImGui::SetCursorScreenPos({max.x - size, max.y - size});
  ImGui::PushID(id);
  if (icon_button("clear", Icon::cross, size, it.colors.dim, "show all")) {
    text.clear();
    changed = true;
  }
  ImGui::PopID();
  ImGui::SetCursorScreenPos(next);
  return changed;
}

bool matches(std::string_view text, std::string_view filter) {
  const auto same = [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); };
  while (true) {
    filter.remove_prefix(std::min(filter.find_first_not_of(' '), filter.size()));
    if (filter.empty()) return true;
    const std::string_view word = filter.substr(0, filter.find(' '));
    if (std::search(text.begin(), text.end(), word.begin(), word.end(), same) == text.end()) return false;
    filter.remove_prefix(word.size());
  }
}

void begin_typing(ImGuiID item, const std::string& initial) { look().typing[item] = {initial, initial, ImGui::GetFrameCount()}; }

bool is_typing(ImGuiID item) { return look().typing.contains(item); }

bool type_over(const char* id, ImVec2 min, ImVec2 max, std::string& text) {
  Look& it = look();
  const ImGuiID item = ImGui::GetID(id);
  const auto found = it.typing.find(item);
  if (found == it.typing.end()) return false;
  Typing& typing = found->second;
  const bool had = ImGui::TempInputIsActive(item);
  if (!had && typing.started) return finish(item, text);
  if (!typing.started) {
    // As ImGui's own drag fields do it: the text field takes the keyboard because it was asked to, not because of a click.
    ImGuiContext& context = *ImGui::GetCurrentContext();
    context.NavActivateId = context.NavActivateInputId = item;
    context.NavActivateFlags = ImGuiActivateFlags_PreferInput;
    typing.started = true;
  }
  typing.text.resize(typed_limit);
  ImGui::TempInputText({min, max}, item, id, typing.text.data(), static_cast<int>(typed_limit), ImGuiInputTextFlags_AutoSelectAll);
  typing.text.resize(typing.text.find('\0'));
  typing.frame = ImGui::GetFrameCount();
  return ImGui::GetActiveID() == item ? false : finish(item, text);
}

}  // namespace lumen::ui
