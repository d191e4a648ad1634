/// How far each occlusion or transparency of the session is from the traced or exact one: numbers, time, memory, and where.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>

#include <imgui.h>

#include <lumen/gl/texture.h>
#include <lumen/ui/color.h>
#include <lumen/ui/color_maps.h>
#include <lumen/ui/look.h>

#include "comparison.h"

namespace {

using namespace lumen;

/// Techniques that are right by construction, the best first.
constexpr const char* truths[] = {"occlusion.traced", "transparency.linked_list", "transparency.peel"};

struct Accuracy : Editor {
  using Editor::Editor;

  Property<Choice> technique{this, "technique", {"occlusion"}, {.doc = "what is compared", .choices = {"occlusion", "transparency"}, .affects = Affects::nothing}};
  Property<std::string> reference{this, "reference", {}, {.doc = "the instance that the others are compared with; empty: the traced or exact one of the session", .affects = Affects::nothing}};
  Property<float> full_scale{this, "full_scale", 0.25f, {.min = 0.001, .max = 1, .doc = "the difference that the picture shows in its brightest color", .logarithmic = true, .affects = Affects::nothing}};
  Property<std::string> file{this, "file", "accuracy.csv", {.doc = "where the table is written", .affects = Affects::nothing}};

  std::string title() const override { return "Accuracy"; }
  void released() override { map_ = {}; }
  void changed(std::string_view property) override { map_stale_ = map_stale_ || property == "full_scale"; }

  void draw(Workbench& workbench) override {
    const std::vector<InstanceState> candidates = of_kind(workbench);
    const InstanceState* truth = truth_of(candidates);
    draw_choices(candidates, truth);
    if (running_) go_on(workbench);
    draw_buttons(workbench, candidates, truth);
    if (comparison_ == nullptr || comparison_->rows().empty()) return;
    // Side by side where there is room.
    const float width = ImGui::GetContentRegionAvail().x;
    const bool beside = width > ui::look()(560);
    if (beside) ImGui::BeginChild("rows", {0.6f * width, 0});
    draw_table();
    if (beside) {
      ImGui::EndChild();
      ImGui::SameLine();
    }
    if (!running_) draw_map();
  }

 private:
  Kind compared_kind() const { return technique->name == "occlusion" ? Kind::occlusion : Kind::transparency; }

  std::vector<InstanceState> of_kind(const Workbench& workbench) const {
    std::vector<InstanceState> found = workbench.instances();
    std::erase_if(found, [&](const InstanceState& state) { return state.kind != compared_kind() || !state.known || !state.enabled; });
    return found;
  }

  /// Null if nobody can be it.
  const InstanceState* truth_of(const std::vector<InstanceState>& candidates) const {
    const auto find = [&](auto fits) {
      const auto found = std::find_if(candidates.begin(), candidates.end(), fits);
      return found == candidates.end() ? nullptr : &*found;
    };
    if (!reference->empty()) return find([&](const InstanceState& state) { return state.id == *reference; });
    for (const char* type : truths)
      if (const InstanceState* truth = find([&](const InstanceState& state) { return state.type == type; })) return truth;
    return nullptr;
  }

  static std::string view_of(const Workbench& workbench) {
    for (const InstanceState& state : workbench.instances())
      if (state.kind == Kind::view) return state.id;
    throw Error("session", "has no view", "add one");
  }

  static bool button(const char* label) {
    const bool pressed = ImGui::Button(label);
    ui::record(label);
    return pressed;
  }

  void draw_choices(const std::vector<InstanceState>& candidates, const InstanceState* truth) {
    const ui::Look& look = ui::look();
    ImGui::SetNextItemWidth(look(130));
    if (ImGui::BeginCombo("##technique", technique->name.c_str())) {
      for (const char* name : {"occlusion", "transparency"})
        if (ImGui::Selectable(name, technique->name == name)) technique.set({name});
      ImGui::EndCombo();
    }
    ui::tooltip("what is compared");
    ImGui::SameLine();
    ui::text("with", look.colors.label);
    ImGui::SameLine();
    ImGui::SetNextItemWidth(look(160));
    if (ImGui::BeginCombo("##reference", truth == nullptr ? "no reference" : truth->id.c_str())) {
      for (const InstanceState& state : candidates)
        if (ImGui::Selectable(state.id.c_str(), truth != nullptr && state.id == truth->id)) reference.set(state.id);
      ImGui::EndCombo();
    }
    ui::tooltip("the instance that the others are compared with: the traced or exact one, if the session has one");
  }

  void go_on(Workbench& workbench) {
    constexpr double seconds_per_frame = 0.008;
    running_ = comparison_->step(workbench, seconds_per_frame);
    shown_ = comparison_->rows().size() > 1 ? 1 : 0;
    map_stale_ = true;
    ui::wake_in(0);
  }

  void draw_buttons(const Workbench& workbench, const std::vector<InstanceState>& candidates, const InstanceState* truth) {
    const ui::Look& look = ui::look();
    if (running_) {
      ImGui::ProgressBar(comparison_->progress(), {look(220), 0}, comparison_->current().c_str());
      ImGui::SameLine();
      if (button("Cancel")) running_ = false;
      return;
    }
    if (truth == nullptr) {
      const bool occlusion = compared_kind() == Kind::occlusion;
      ui::text(std::string("Add ") + (occlusion ? "occlusion.traced" : "transparency.linked_list") + " to the session to compare with.", look.colors.dim);
      return;
    }
    if (button("Compare")) {
      comparison_ = std::make_unique<Comparison>(view_of(workbench), compared_kind(), *truth, candidates);
      running_ = true;
      said_.clear();
      ui::wake_in(0);
    }
    ui::tooltip("draw the view with each technique, to its last refinement");
    if (comparison_ == nullptr || comparison_->rows().empty()) return;
    ImGui::SameLine();
    if (button("Write table")) write();
    ImGui::SameLine();
    char name[256];
    std::snprintf(name, sizeof name, "%s", file->c_str());
    ImGui::SetNextItemWidth(look(180));
    if (ImGui::InputText("##file", name, sizeof name)) file.set(name);
    ui::tooltip("where the table is written, comma-separated");
    if (!said_.empty()) ui::text(said_, said_failed_ ? look.colors.error : look.colors.dim);
  }

  void write() {
    try {
      comparison_->write_csv(*file);
      said_ = "wrote " + *file;
      said_failed_ = false;
    } catch (const std::exception& error) {
      said_ = error.what();
      said_failed_ = true;
    }
  }

  void draw_table() {
    const ui::Look& look = ui::look();
    if (!ImGui::BeginTable("table", 6, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp)) return;
    for (const char* heading : {"instance", "RMSE", "largest", "structural", "ms", "MB"}) ImGui::TableSetupColumn(heading);
    ImGui::TableHeadersRow();
    const auto& rows = comparison_->rows();
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Comparison::Row& row = rows[i];
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      if (ImGui::Selectable(row.instance.c_str(), int(i) == shown_, ImGuiSelectableFlags_SpanAllColumns)) shown_ = int(i), map_stale_ = true;
      ui::record(row.instance);
      ui::tooltip(row.failure.empty() ? row.type + (i == 0 ? ": the reference" : ": click to see where it differs") : row.failure);
      if (!row.failure.empty()) {
        ImGui::TableNextColumn();
        ui::text("failed", look.colors.error);
        continue;
      }
      const ui::FontScope font(look.mono);
      const auto number = [](const char* format, double value) {
        ImGui::TableNextColumn();
        ImGui::Text(format, value);
      };
      number("%.4f", row.difference.rmse);
      number("%.3f", row.difference.largest);
      number("%.4f", row.difference.structural);
      number("%.1f", row.milliseconds);
      number("%.1f", double(row.bytes) / 1e6);
    }
    ImGui::EndTable();
  }

  /// Where the chosen technique differs, by color.
  void draw_map() {
    const ui::Look& look = ui::look();
    const auto& rows = comparison_->rows();
    if (shown_ < 0 || shown_ >= int(rows.size()) || rows[std::size_t(shown_)].difference.map.empty()) return;
    const int width = comparison_->width(), height = comparison_->height();
    if (map_stale_ || !map_) {
      const float scale = full_scale;
      const TransferFunction colors = ui::with_colors({.range = {0, scale}, .points = {{0, glm::vec4(0, 0, 0, 1)}, {scale, glm::vec4(1)}}}, "heat");
      std::vector<float> texels;
      texels.reserve(std::size_t(width) * std::size_t(height) * 4);
      for (const float off : rows[std::size_t(shown_)].difference.map) {
        const glm::vec3 color = ui::to_srgb(glm::vec3(colors.at(std::min(off, scale))));
        texels.insert(texels.end(), {color.r, color.g, color.b, 1});
      }
      if (!map_ || map_.size() != glm::ivec2(width, height)) map_ = gl::Texture(Format::RGBA8, {width, height});
      map_.upload(texels.data());
      map_.linear();
      map_stale_ = false;
    }
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float scale = std::min(room.x / float(width), std::max(room.y, look(120)) / float(height));
    ImGui::Image(reinterpret_cast<ImTextureID>(std::uintptr_t(map_.name())), {scale * float(width), scale * float(height)});
    ui::record("difference");
    ui::tooltip("where " + rows[std::size_t(shown_)].instance + " differs from the reference; the brightest color is " + std::to_string(full_scale.get()));
  }

  std::unique_ptr<Comparison> comparison_;
  bool running_ = false;
  int shown_ = 0;                ///< row whose difference is shown
  gl::Texture map_;
  bool map_stale_ = true;
  std::string said_;
  bool said_failed_ = false;
};

}  // namespace

LUMEN_PLUGIN(Accuracy, "editor.accuracy", "how far each occlusion or transparency of the session is from the traced or exact one")
