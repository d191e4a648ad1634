#include "window/add_popup.h"

#include <algorithm>
#include <cfloat>
#include <utility>

#include <imgui.h>

#include <lumen/ui/look.h>
#include <lumen/ui/text_field.h>

namespace lumenshop {

void AddPopup::open(std::vector<TypeInfo> types) {
  types_ = std::move(types);
  filter_.clear();
  open_ = appears_ = true;
}

void AddPopup::draw(const std::function<void(const std::string& type)>& add) {
  if (!open_) return;
  lumen::ui::Look& look = lumen::ui::look();
  if (appears_) ImGui::OpenPopup("add instance");
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({window.x / 2, window.y * 0.3f}, ImGuiCond_Appearing, {0.5f, 0.2f});
  ImGui::SetNextWindowSize({std::min(look(520), window.x), std::min(look(420), window.y)});
  if (!ImGui::BeginPopup("add instance")) {
    open_ = false;
    return;
  }
  look.panel = "add";
  if (std::exchange(appears_, false)) ImGui::SetKeyboardFocusHere();
  lumen::ui::search_field("filter", filter_, -FLT_MIN, "What to add: a kind, a name, a word of its description");
  std::string chosen;
  ImGui::BeginChild("types");
  for (const TypeInfo& type : types_) {
    if (!lumen::ui::matches(type.id + " " + type.doc, filter_)) continue;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::Selectable(("##" + type.id).c_str());
    lumen::ui::record(type.id);
    // Enter takes the first one that fits.
    const bool entered = chosen.empty() && !filter_.empty() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false);
    if (pressed || entered) chosen = type.id;
    ImDrawList* list = ImGui::GetWindowDrawList();
    list->AddText(corner, look.colors.text, type.id.c_str());
    lumen::ui::text_elided(list, {corner.x + look(190), corner.y}, ImGui::GetContentRegionAvail().x - look(190), type.doc, look.colors.dim);
  }
  ImGui::EndChild();
  if (!chosen.empty() || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) {
    open_ = false;
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
  if (!chosen.empty()) add(chosen);
}

}  // namespace lumenshop
