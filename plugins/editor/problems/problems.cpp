/// What is wrong, where, and what to do about it: of all instances, files and builds.
#include <algorithm>
#include <fstream>

#include <imgui.h>

#include <lumen/editor.h>
#include <lumen/ui/icons.h>
#include <lumen/ui/look.h>

namespace {

using namespace lumen;

std::string place_of(const Problem& problem) {
  if (problem.file.empty()) return problem.instance;
  std::string place = problem.file.substr(problem.file.rfind('/') + 1);
  if (problem.line > 0) place += ":" + std::to_string(problem.line);
  if (problem.line > 0 && problem.column > 0) place += ":" + std::to_string(problem.column);
  return place;
}

/// The line and its neighbors, for the tooltip.
std::string lines_around(const std::string& file, int line) {
  constexpr int furthest = 200'000;
  constexpr std::size_t widest = 160;
  std::ifstream stream(file);
  std::string text, result;
  for (int number = 1; number <= std::min(line + 1, furthest) && std::getline(stream, text); ++number)
    if (number >= line - 1) result += (result.empty() ? "" : "\n") + std::to_string(number) + "  " + text.substr(0, widest);
  return result;
}

struct Problems : Editor {
  using Editor::Editor;

  std::string title() const override { return "Problems"; }

  void draw(Workbench& workbench) override {
    const ui::Look& look = ui::look();
    auto problems = workbench.problems();
    std::stable_sort(problems.begin(), problems.end(), [](const Problem& a, const Problem& b) { return a.severity > b.severity; });
    if (problems.empty()) {
      ui::text("No problems.", look.colors.dim);
      return;
    }
    ImGui::BeginChild("list");
    for (std::size_t index = 0; index < problems.size(); ++index) {
      ImGui::PushID(static_cast<int>(index));
      draw_row(workbench, problems[index]);
      ImGui::PopID();
    }
    ImGui::EndChild();
  }

 private:
  static void draw_row(Workbench& workbench, const Problem& problem) {
    const ui::Look& look = ui::look();
    const ImU32 color = problem.severity == Severity::error ? look.colors.error : problem.severity == Severity::warning ? look.colors.warning : look.colors.label;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetTextLineHeight() + look(4);
    const float place_width = std::clamp(width * 0.28f, look(120), look(260));
    const bool pressed = ImGui::InvisibleButton("row", {width, height});
    ui::record("row");
    ImDrawList* list = ImGui::GetWindowDrawList();
    if (ImGui::IsItemHovered()) list->AddRectFilled(corner, {corner.x + width, corner.y + height}, look.colors.hover, look(3));
    const ui::Icon icon = problem.severity == Severity::note ? ui::Icon::dot : ui::Icon::triangle;
    ui::draw_icon(list, icon, {corner.x + look(2), corner.y + (height - look(11)) / 2}, look(11), color);
    const ui::FontScope font(look.mono);
    const float top = corner.y + (height - ImGui::GetFontSize()) / 2;
    ui::text_elided(list, {corner.x + look(20), top}, place_width - look(26), place_of(problem), color);
    const std::string first_line = problem.message.substr(0, problem.message.find('\n'));
    ui::text_elided(list, {corner.x + place_width, top}, width - place_width, first_line, look.colors.text);

    if (pressed && !problem.file.empty()) workbench.open_source(problem.file, std::max(1, problem.line));
    else if (pressed && !problem.instance.empty()) workbench.select(problem.instance);
    if (ImGui::IsItemHovered() && ImGui::IsMouseReleased(1)) ImGui::SetClipboardText((place_of(problem) + ": " + problem.message).c_str());
    if (ui::begin_tooltip()) {
      ui::text(problem.message, look.colors.text);
      if (problem.line > 0) ui::text(lines_around(problem.file, problem.line), look.colors.label);
      ui::text(problem.file.empty() ? "click: select it; right click: copy" : "click: open it in $VISUAL; right click: copy", look.colors.dim);
      ui::end_tooltip();
    }
  }
};

}  // namespace

LUMEN_PLUGIN(Problems, "editor.problems", "what is wrong, where, and what to do about it")
