#include <lumen/ui/look.h>

#include <algorithm>

#include <imgui_internal.h>

#include <lumen/error.h>

namespace lumen::ui {

Look& look() {
  auto* look = static_cast<Look*>(ImGui::GetIO().UserData);
  if (!look) throw Error("window", "no look is set on the ImGui context", "panels are drawn by the host's window alone");
  return *look;
}

void record(std::string_view path, ImVec2 min, ImVec2 max) {
  const Look& it = look();
  if (it.record) it.record(it.panel + "/" + std::string(path), min, max);
}
void record(std::string_view path) { record(path, ImGui::GetItemRectMin(), ImGui::GetItemRectMax()); }

void take_keys() { look().keys_frame = ImGui::GetFrameCount(); }

void wake_in(double seconds) {
  Look& it = look();
  const double when = ImGui::GetTime() + seconds;
  it.wake_at = it.wake_at > 0 ? std::min(it.wake_at, when) : when;
}

void text(std::string_view text, ImU32 color) {
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopStyleColor();
}

void text_elided(ImDrawList* list, ImVec2 position, float width, std::string_view text, ImU32 color, bool keep_end) {
  const auto width_of = [](std::string_view part) { return ImGui::CalcTextSize(part.data(), part.data() + part.size()).x; };
  if (width_of(text) <= width) {
    list->AddText(position, color, text.data(), text.data() + text.size());
    return;
  }
  const std::string_view ellipsis = "...";
  const float room = width - width_of(ellipsis);
  if (room <= 0) return;
  std::size_t low = 0, high = text.size();
  const auto part = [&](std::size_t count) { return keep_end ? text.substr(text.size() - count) : text.substr(0, count); };
  while (low < high) {
    const std::size_t middle = (low + high + 1) / 2;
    if (width_of(part(middle)) <= room) low = middle; else high = middle - 1;
  }
  // Never cut inside a UTF-8 sequence.
  const auto continues = [&](std::size_t index) { return index < text.size() && (static_cast<unsigned char>(text[index]) & 0xC0) == 0x80; };
  while (low > 0 && continues(keep_end ? text.size() - low : low)) --low;
  const std::string shown = keep_end ? std::string(ellipsis) + std::string(part(low)) : std::string(part(low)) + std::string(ellipsis);
  list->AddText(position, color, shown.c_str());
}

bool begin_tooltip() {
  constexpr double delay = 0.5;
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) || ImGui::IsMouseDown(0) || ImGui::IsAnyItemActive()) return false;
  // The time since the pointer came to rest on this item, kept with the window: ImGui 1.86 has no delayed tooltips.
  ImGuiStorage* storage = ImGui::GetStateStorage();
  const ImVec2 corner = ImGui::GetItemRectMin();
  const ImGuiID item = ImGui::GetID("tooltip") ^ static_cast<ImGuiID>(corner.x * 8191 + corner.y);
  const ImGuiID since = ImGui::GetID("tooltip since"), which = ImGui::GetID("tooltip which");
  if (static_cast<ImGuiID>(storage->GetInt(which)) != item) {
    storage->SetInt(which, static_cast<int>(item));
    storage->SetFloat(since, static_cast<float>(ImGui::GetTime()));
  }
  const double waited = ImGui::GetTime() - storage->GetFloat(since);
  if (waited < delay) {
    wake_in(delay - waited + 0.01);
    return false;
  }
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(look()(380));
  return true;
}

void end_tooltip() {
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void tooltip(std::string_view words) {
  if (!begin_tooltip()) return;
  text(words, look().colors.text);
  end_tooltip();
}

}  // namespace lumen::ui
