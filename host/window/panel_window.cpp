#include "window/panel_window.h"

#include <algorithm>

#include <imgui.h>

#include <lumen/ui/look.h>

namespace lumenshop {
namespace {

constexpr ImGuiWindowFlags placed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

/// One handle. `sign`: which way dragging makes the panel larger.
bool splitter(const char* id, const Rectangle& place, bool across, float sign, float fallback, float scale, float& size) {
  if (place.empty()) return false;
  ImGui::SetNextWindowPos({place.min.x, place.min.y});
  ImGui::SetNextWindowSize({place.size().x, place.size().y});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::Begin(id, nullptr, (placed & ~ImGuiWindowFlags_NoBringToFrontOnFocus) | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::InvisibleButton("handle", {place.size().x, place.size().y});
  lumen::ui::look().panel = "splitter";
  lumen::ui::record(id);
  const bool active = ImGui::IsItemActive();
  if (ImGui::IsItemHovered() || active) {
    ImGui::SetMouseCursor(across ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
    const float middle_x = (place.min.x + place.max.x) / 2, middle_y = (place.min.y + place.max.y) / 2;
    const ImVec2 from(across ? middle_x - 1 : place.min.x, across ? place.min.y : middle_y - 1), to(across ? middle_x + 1 : place.max.x, across ? place.max.y : middle_y + 1);
    ImGui::GetWindowDrawList()->AddRectFilled(from, to, lumen::ui::look().colors.border);
  }
  bool done = ImGui::IsItemDeactivated();
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) {
    size = fallback;
    done = true;
  } else if (active) {
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    size = std::clamp(size + sign * (across ? moved.x : moved.y) / scale, across ? Layout::smallest : 60.0f, 2000.0f);
  }
  ImGui::End();
  ImGui::PopStyleVar(2);
  return done;
}

}  // namespace

PanelWindow::PanelWindow(const char* name, const Rectangle& place, bool padded) {
  lumen::ui::look().panel = name;
  ImGui::SetNextWindowPos({place.min.x, place.min.y});
  ImGui::SetNextWindowSize({place.size().x, place.size().y});
  if (!padded) ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::Begin(name, nullptr, placed);
  if (!padded) ImGui::PopStyleVar();
  // A hairline parts panels from what stands beside them.
  const lumen::ui::Look& look = lumen::ui::look();
  ImGui::GetWindowDrawList()->AddRect({place.min.x - 1, place.min.y}, {place.max.x, place.max.y + 1}, look.colors.canvas);
}

PanelWindow::~PanelWindow() { ImGui::End(); }

bool drag_splitters(const Layout& layout, float scale, PanelSizes& sizes) {
  bool done = splitter("##outline splitter", layout.outline_splitter, true, 1, PanelSizes::outline_default, scale, sizes.outline);
  done |= splitter("##properties splitter", layout.properties_splitter, true, -1, PanelSizes::properties_default, scale, sizes.properties);
  done |= splitter("##bottom splitter", layout.bottom_splitter, false, -1, PanelSizes::bottom_default, scale, sizes.bottom);
  return done;
}

}  // namespace lumenshop
