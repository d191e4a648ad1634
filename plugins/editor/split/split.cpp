/// Cuts by planes in image space and in object space: what both cost, and the change from one to the other.
#include <cstdio>
#include <map>

#include <imgui.h>

#include <lumen/editor.h>
#include <lumen/ui/look.h>

#include "baking.h"
#include "measurement.h"

namespace {

using namespace lumen;

/// As `format` says; a dash for what is not known.
std::string number(const char* format, double value) {
  if (!(value > 0)) return "-";
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

struct SplitCosts : Editor {
  using Editor::Editor;

  std::string title() const override { return "Split"; }

  void draw(Workbench& workbench) override {
    const ui::Look& look = ui::look();
    const std::vector<CutSurface> cuts = cut_surfaces(workbench);
    if (cuts.empty()) {
      ui::text("No surface is cut by a plane. Give one a splitter.plane.", look.colors.dim);
      return;
    }
    try {
      if (measurement_) go_on(workbench);
    } catch (const Error& error) {
      measurement_.reset();
      ui::look().notice = error.what();
    }
    if (!ImGui::BeginTable("cuts", 8, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_ScrollX)) return;
    for (const char* heading : {"surface", "plane", "triangles", "each frame", "not cut", "once", "memory", ""}) ImGui::TableSetupColumn(heading);
    ImGui::TableHeadersRow();
    for (const CutSurface& cut : cuts) draw_row(workbench, cut);
    ImGui::EndTable();
  }

 private:
  /// What was measured of a surface and its plane.
  struct Costs {
    double with_cut = 0, without_cut = 0;  ///< milliseconds of a frame; 0: not measured
    double begun = 0, once = 0;            ///< ImGui time when the filter was begun, 0: it is not at work; seconds that it took
  };

  void go_on(Workbench& workbench) {
    if (!measurement_->step(workbench)) {
      Costs& costs = costs_[{measurement_->surface, measurement_->splitter}];
      costs.with_cut = measurement_->with_cut();
      costs.without_cut = measurement_->without_cut();
      measurement_.reset();
    }
    ui::wake_in(0);
  }

  void draw_row(Workbench& workbench, const CutSurface& cut) {
    const ui::Look& look = ui::look();
    Costs& costs = costs_[{cut.surface, cut.plane}];
    watch(workbench, cut, costs);
    ImGui::PushID((cut.surface + "/" + cut.plane).c_str());
    ImGui::TableNextRow();
    const auto cell = [&](const std::string& text, bool in_use) {
      ImGui::TableNextColumn();
      ImGui::AlignTextToFramePadding();
      ui::text(text, in_use ? look.colors.text : look.colors.dim);
    };
    cell(cut.surface, true);
    cell(cut.plane, true);
    cell(cut.mesh ? grouped(cut.mesh->triangles.size()) : "-", true);
    cell(number("%.1f ms", costs.with_cut), !cut.once);
    ui::tooltip("a frame of the view as the splitter cuts it, drawn at the view's size");
    cell(number("%.1f ms", costs.without_cut), cut.once);
    ui::tooltip("a frame without the cut: about what one costs that the filter has cut");
    cell(costs.begun > 0 ? "at work" : number("%.2f s", costs.once), cut.once);
    ui::tooltip("how long filter.split took, beside the window");
    cell(number("%.1f MB", 1e-6 * double(cut.filter.empty() ? 0 : bytes_of_halves(workbench, cut.filter))), cut.once);
    ui::tooltip("of both halves, apart and in one mesh");
    ImGui::TableNextColumn();
    draw_buttons(workbench, cut, costs);
    ImGui::PopID();
  }

  /// Notes how long the filter takes.
  static void watch(const Workbench& workbench, const CutSurface& cut, Costs& costs) {
    if (costs.begun == 0) return;
    const auto result = workbench.property(cut.filter + ".result");
    if (cut.once && result && result->data_state == "pending") return ui::wake_in(0.02);
    if (cut.once && result && result->data_state == "ready") costs.once = ImGui::GetTime() - costs.begun;
    costs.begun = 0;
  }

  void draw_buttons(Workbench& workbench, const CutSurface& cut, Costs& costs) {
    const auto button = [&](const char* label, const std::string& name, const char* why) {
      const bool pressed = ImGui::Button(label);
      ui::record(name + ":" + cut.surface);
      ui::tooltip(why);
      return pressed;
    };
    if (measurement_ && measurement_->surface == cut.surface && measurement_->splitter == cut.plane) {
      ImGui::ProgressBar(measurement_->progress());
      return;
    }
    try {
      if (cut.once) {
        if (button("Cut in each frame", "live", "back to the splitter, whose plane can be dragged; the filter stays, switched off")) cut_each_frame(workbench, cut);
        return;
      }
      ImGui::BeginDisabled(measurement_ != nullptr);
      if (button("Measure", "measure", "draw some frames with the cut and without")) measurement_ = std::make_unique<Measurement>(view_of(workbench), cut.surface, cut.plane), ui::wake_in(0);
      ImGui::EndDisabled();
      ImGui::SameLine();
      if (!button("Cut once", "once", "filter.split makes the halves a mesh of their own; they follow the plane as before, but slower")) return;
      cut_once(workbench, cut);
      costs.begun = ImGui::GetTime();
      ui::wake_in(0);
    } catch (const Error& error) {
      ui::look().notice = error.what();
    }
  }

  static std::string view_of(const Workbench& workbench) {
    for (const InstanceState& state : workbench.instances())
      if (state.kind == Kind::view) return state.id;
    throw Error("session", "has no view", "add one");
  }

  std::unique_ptr<Measurement> measurement_;
  std::map<std::pair<std::string, std::string>, Costs> costs_;  ///< of a surface and its plane
};

}  // namespace

LUMEN_PLUGIN(SplitCosts, "editor.split", "what cuts by planes cost in image space and in object space, and the change from one to the other. Schwankl, Splitting of Meshes in Image-Space, Vienna 2013")
