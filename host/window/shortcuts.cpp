#include "window/shortcuts.h"

#include <algorithm>
#include <utility>

#include <imgui.h>

#include <lumen/ui/look.h>

namespace lumenshop {
namespace {

/// What the mouse does is in no table: it has no command.
constexpr std::pair<const char*, const char*> mouse[] = {
    {"left drag", "orbit"}, {"middle or Shift + left drag", "pan"}, {"wheel, right or Ctrl + left drag", "zoom to the pointer"},
    {"Ctrl + Shift + left drag", "roll"}, {"double click", "pivot here; on the background: fit all"}, {"L + left drag", "turn the light"},
    {"click, Shift or Ctrl + click", "pick; add to what is picked or remove from it"},
    {"drag a plane's handle", "move or turn it; Shift: fine, Ctrl: steps, Esc: as it was"}, {"double click a plane's handle", "turn the plane to the eye"}};

}  // namespace

void draw_shortcuts(const CommandTable& commands, bool& open) {
  lumen::ui::Look& look = lumen::ui::look();
  if (std::exchange(open, false)) ImGui::OpenPopup("Keys and mouse");
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({window.x / 2, window.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(look(640), window.x), std::min(look(560), window.y)});
  if (!ImGui::BeginPopup("Keys and mouse")) return;
  look.panel = "help";
  const auto row = [&](const char* keys, const std::string& what) {
    {
      const lumen::ui::FontScope mono(look.mono);
      lumen::ui::text(keys, look.colors.label);
    }
    ImGui::SameLine(look(320));
    lumen::ui::text(what, look.colors.text);
  };
  for (const auto& [gesture, what] : mouse) row(gesture, what);
  ImGui::Separator();
  for (const Command& command : commands.all())
    if (!command.keys.empty()) row(command.keys.c_str(), command.title);
  ImGui::EndPopup();
}

}  // namespace lumenshop
