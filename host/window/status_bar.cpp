#include "window/status_bar.h"

#include <cstdio>

#include <imgui.h>

#include <lumen/ui/icons.h>
#include <lumen/ui/look.h>

namespace lumenshop {
namespace {

constexpr double shown_after = 0.3;  // seconds that work takes before it is worth a line

/// "reading aorta.vtp 62 %, 3 s left"
std::string words_of(const JobStatus& job) {
  std::string words = job.title + " " + std::to_string(static_cast<int>(job.fraction * 100)) + " %";
  if (job.fraction > 0.05f && job.seconds > 2) words += ", " + std::to_string(static_cast<int>(job.seconds * (1 - job.fraction) / job.fraction) + 1) + " s left";
  return words;
}

}  // namespace

void draw_status_bar(const Rectangle& place, const Status& status) {
  lumen::ui::Look& look = lumen::ui::look();
  look.panel = "status";
  ImGui::PushStyleColor(ImGuiCol_WindowBg, look.colors.canvas);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {look(10), 0});
  ImGui::SetNextWindowPos({place.min.x, place.min.y});
  ImGui::SetNextWindowSize({place.size().x, place.size().y});
  ImGui::Begin("##status", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus);
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float top = place.min.y + (place.size().y - ImGui::GetFontSize()) / 2;

  float right = place.max.x - look(10);
  const auto from_right = [&](const std::string& words, ImU32 color) {
    const lumen::ui::FontScope mono(look.mono);
    right -= ImGui::CalcTextSize(words.c_str()).x;
    list->AddText({right, top}, color, words.c_str());
    right -= look(20);
  };
  if (status.size.x > 0) {
    char text[32];
    std::snprintf(text, sizeof text, "%dx%d", status.size.x, status.size.y);
    from_right(text, look.colors.dim);
    std::snprintf(text, sizeof text, "%.1f ms", status.milliseconds);
    from_right(text, look.colors.dim);
  }
  for (const JobStatus& job : status.jobs) {
    if (job.seconds < shown_after) continue;
    const float size = look(18);
    right -= size;
    ImGui::SetCursorScreenPos({right, place.min.y + (place.size().y - size) / 2});
    ImGui::PushID(job.instance.c_str());
    if (lumen::ui::icon_button("cancel", lumen::ui::Icon::cross, size, look.colors.label, "cancel; the last result stays") && status.cancel) status.cancel(job.instance);
    ImGui::PopID();
    right -= look(6);
    const float end = right;
    from_right(words_of(job), look.colors.label);
    const float begin = right + look(20);
    list->AddRectFilled({begin, place.max.y - look(4)}, {begin + (end - begin) * job.fraction, place.max.y - look(2)}, look.colors.label);
  }
  if (status.building) {
    from_right("building", look.colors.driven);
    right -= look(2);
    lumen::ui::draw_icon(list, lumen::ui::Icon::refresh, {right, place.min.y + (place.size().y - look(12)) / 2}, look(12), look.colors.driven);
  }

  const std::string hints = status.blender_keys ? "middle drag: orbit   shift + middle: pan   wheel: zoom   right click: menu"
                                                : "drag: orbit   middle: pan   right: zoom   wheel: zoom   right click: menu";
  lumen::ui::text_elided(list, {place.min.x + look(10), top}, right - place.min.x - look(10), hints, look.colors.dim);
  ImGui::End();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
}

}  // namespace lumenshop
