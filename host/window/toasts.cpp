#include "window/toasts.h"

#include <algorithm>

#include <imgui.h>
#include <imgui_internal.h>

#include <lumen/ui/look.h>

namespace lumenshop {
namespace {

constexpr std::size_t most_shown = 3, most_logged = 10'000;

/// Words that act when clicked.
bool link(const char* words) {
  const lumen::ui::Look& look = lumen::ui::look();
  lumen::ui::text(words, look.colors.driven);
  if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  return ImGui::IsItemClicked();
}

}  // namespace

void Toasts::show(lumen::Severity severity, std::string title, std::string details, std::string about) {
  log_.push_back(details.empty() ? title : title + ": " + details);
  if (log_.size() > most_logged) log_.erase(log_.begin(), log_.begin() + most_logged / 2);
  for (const Toast& toast : shown_)
    if (toast.title == title && toast.details == details) return;
  shown_.push_back({severity, std::move(title), std::move(details), std::move(about)});
  if (shown_.size() > most_shown) shown_.pop_front();
}

void Toasts::dismiss(const std::string& about) {
  std::erase_if(shown_, [&](const Toast& toast) { return toast.about == about; });
}

bool Toasts::draw_one(Toast& toast, std::size_t index, const Rectangle& view, float& bottom) {
  const lumen::ui::Look& look = lumen::ui::look();
  const float width = std::min(look(320), view.size().x - look(16));
  ImGui::SetNextWindowPos({view.max.x - look(8), bottom}, ImGuiCond_Always, {1, 1});
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, view.size().y * 0.5f});
  const std::string name = "##toast" + std::to_string(index);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, look(4));
  ImGui::Begin(name.c_str(), nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize);
  const ImU32 color = toast.severity == lumen::Severity::error ? look.colors.error : toast.severity == lumen::Severity::warning ? look.colors.warning : look.colors.done;
  const ImVec2 corner = ImGui::GetWindowPos();
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->PushClipRectFullScreen();
  list->AddRectFilled(corner, {corner.x + look(4), corner.y + ImGui::GetWindowHeight()}, color, look(2));
  list->PopClipRect();
  ImGui::Indent(look(4));
  ImGui::PushTextWrapPos(0);
  {
    const lumen::ui::FontScope font(look.heading);
    lumen::ui::text(toast.title, look.colors.text);
  }
  if (!toast.details.empty()) lumen::ui::text(toast.details.substr(0, 600), look.colors.label);
  ImGui::PopTextWrapPos();
  bool keep = true;
  if (link("Copy")) ImGui::SetClipboardText((toast.title + "\n" + toast.details).c_str());
  ImGui::SameLine(0, look(16));
  if (link("Dismiss")) keep = false;
  const bool rests = ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows);
  ImGui::Unindent(look(4));
  if (!ImGui::IsWindowAppearing()) bottom -= ImGui::GetWindowHeight() + look(6);
  ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
  ImGui::End();
  ImGui::PopStyleVar();
  if (toast.severity != lumen::Severity::error && !rests) {
    // A long idle between two frames must not eat a toast that has not been seen.
    toast.left -= std::min(ImGui::GetIO().DeltaTime, 0.5f);
    keep = keep && toast.left > 0;
    lumen::ui::wake_in(std::clamp(toast.left, 0.02, 0.4));
  }
  return keep;
}

void Toasts::draw(const Rectangle& view, bool errors_alone) {
  float bottom = view.max.y - lumen::ui::look()(8);
  for (std::size_t index = shown_.size(); index-- > 0;)
    if ((!errors_alone || shown_[index].severity == lumen::Severity::error) && !draw_one(shown_[index], index, view, bottom)) shown_.erase(shown_.begin() + static_cast<std::ptrdiff_t>(index));
}

}  // namespace lumenshop
