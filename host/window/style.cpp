#include "window/style.h"

#include <algorithm>
#include <cmath>

#include <imgui.h>

namespace lumenshop {
namespace {

constexpr float field_height = 25, gap = 3, padding = 8, radius = 3;

}  // namespace

void apply_imgui_style(const lumen::ui::Look& look) {
  using lumen::ui::faded;
  ImGuiStyle style;
  const auto pixels = [&](float units) { return std::max(1.0f, std::round(look(units))); };
  const float text_height = look.text ? look.text->FontSize : 13;
  style.WindowPadding = {pixels(padding), pixels(padding)};
  style.FramePadding = {pixels(padding), std::max(1.0f, std::floor((look(field_height) - text_height) / 2))};
  style.ItemSpacing = {pixels(padding), pixels(gap)};
  style.ItemInnerSpacing = {pixels(gap), pixels(gap)};
  style.IndentSpacing = pixels(14);
  style.ScrollbarSize = pixels(10);
  style.GrabMinSize = pixels(8);
  style.WindowRounding = 0;
  style.ChildRounding = 0;
  style.FrameRounding = style.PopupRounding = style.ScrollbarRounding = style.GrabRounding = style.TabRounding = pixels(radius);
  style.WindowBorderSize = style.ChildBorderSize = 0;
  style.PopupBorderSize = 1;
  style.FrameBorderSize = look.colors.bordered ? 1 : 0;
  style.WindowMinSize = {1, 1};
  style.DisplaySafeAreaPadding = {0, 0};

  const lumen::ui::Palette& colors = look.colors;
  const auto set = [&](ImGuiCol index, ImU32 color) { style.Colors[index] = ImGui::ColorConvertU32ToFloat4(color); };
  for (int index = 0; index < ImGuiCol_COUNT; ++index) set(index, colors.field);
  set(ImGuiCol_Text, colors.text);
  set(ImGuiCol_TextDisabled, colors.dim);
  set(ImGuiCol_WindowBg, colors.panel);
  set(ImGuiCol_ChildBg, faded(colors.panel, 0));
  set(ImGuiCol_PopupBg, colors.panel);
  set(ImGuiCol_MenuBarBg, colors.canvas);
  set(ImGuiCol_Border, colors.border);
  set(ImGuiCol_BorderShadow, faded(colors.border, 0));
  for (const ImGuiCol index : {ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive, ImGuiCol_ButtonHovered, ImGuiCol_ButtonActive, ImGuiCol_HeaderHovered,
                               ImGuiCol_TabHovered, ImGuiCol_ScrollbarGrabHovered, ImGuiCol_ScrollbarGrabActive})
    set(index, colors.hover);
  for (const ImGuiCol index : {ImGuiCol_Header, ImGuiCol_HeaderActive, ImGuiCol_TextSelectedBg}) set(index, colors.selection);
  for (const ImGuiCol index : {ImGuiCol_CheckMark, ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive}) set(index, colors.text);
  for (const ImGuiCol index : {ImGuiCol_Separator, ImGuiCol_SeparatorHovered, ImGuiCol_SeparatorActive}) set(index, faded(colors.border, 0.6f));
  set(ImGuiCol_ScrollbarBg, faded(colors.panel, 0));
  set(ImGuiCol_TitleBgActive, colors.panel);
  set(ImGuiCol_TabActive, colors.panel);
  set(ImGuiCol_NavHighlight, colors.focus);
  set(ImGuiCol_DragDropTarget, colors.driven);
  set(ImGuiCol_ModalWindowDimBg, IM_COL32(0, 0, 0, 128));
  ImGui::GetStyle() = style;
}

}  // namespace lumenshop
