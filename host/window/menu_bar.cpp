#include "window/menu_bar.h"

#include <imgui.h>

#include <lumen/ui/look.h>

#include "window/panel_window.h"

namespace lumenshop {

void draw_menu_entries(const CommandTable& commands, const std::string& menu) {
  for (const Command& command : commands.all()) {
    if (command.menu != menu) continue;
    if (command.separated) ImGui::Separator();
    const bool enabled = !command.enabled || command.enabled();
    const bool checked = command.checked && command.checked();
    const bool chosen = ImGui::MenuItem(command.title.c_str(), command.keys.empty() ? nullptr : command.keys.c_str(), checked, enabled);
    lumen::ui::record(command.id);
    if (chosen) command.run();
  }
}

void draw_menu_bar(const Rectangle& place, const CommandTable& commands, const std::string& title, bool modified) {
  lumen::ui::Look& look = lumen::ui::look();
  ImGui::PushStyleColor(ImGuiCol_WindowBg, look.colors.canvas);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {look(4), 0});
  ImGui::SetNextWindowPos({place.min.x, place.min.y});
  ImGui::SetNextWindowSize({place.size().x, place.size().y});
  look.panel = "menu";
  ImGui::Begin("##menu bar", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_MenuBar |
                   ImGuiWindowFlags_NoBringToFrontOnFocus);
  ImGui::PopStyleVar();  // menus have the padding of other windows
  if (ImGui::BeginMenuBar()) {
    for (const char* menu : {"File", "Edit", "Add", "View", "Window", "Help"}) {
      const bool open = ImGui::BeginMenu(menu);
      lumen::ui::record(menu);
      if (!open) continue;
      draw_menu_entries(commands, menu);
      ImGui::EndMenu();
    }
    const lumen::ui::FontScope font(look.heading);
    const std::string words = modified ? title + " \xE2\x80\xA2" : title;
    const float width = ImGui::CalcTextSize(words.c_str()).x, left = place.min.x + (place.size().x - width) / 2;
    if (left > ImGui::GetCursorScreenPos().x + look(8))
      ImGui::GetWindowDrawList()->AddText({left, place.min.y + (place.size().y - ImGui::GetFontSize()) / 2}, look.colors.text, words.c_str());
    ImGui::EndMenuBar();
  }
  ImGui::End();
  ImGui::PopStyleColor();
}

}  // namespace lumenshop
