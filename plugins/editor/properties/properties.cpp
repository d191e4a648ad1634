/// The properties of the selected instance, a control each.
#include <algorithm>
#include <cfloat>

#include <imgui.h>

#include <lumen/editor.h>
#include <lumen/ui/look.h>
#include <lumen/ui/property_row.h>
#include <lumen/ui/text_field.h>

namespace {

using namespace lumen;

bool found(const PropertyState& state, const std::string& filter, const Workbench& workbench) {
  if (filter.empty()) return true;
  const bool is_data = state.spec.type == ValueType::data;
  return ui::matches(ui::label_of(state.spec.id) + " " + state.spec.id + " " + state.spec.options.doc + " " + (is_data ? "" : workbench.to_json(state.value)), filter);
}

/// A group's heading; folds. True while open.
bool heading(const std::string& title) {
  const ui::Look& look = ui::look();
  ImGuiStorage* storage = ImGui::GetStateStorage();
  const ImGuiID key = ImGui::GetID((title + " folded").c_str());
  const float height = ImGui::GetFrameHeight(), width = ImGui::GetContentRegionAvail().x;
  ImGui::Dummy({0, look(2)});
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  if (ImGui::InvisibleButton(title.c_str(), {width, height})) storage->SetBool(key, !storage->GetBool(key));
  const bool folded = storage->GetBool(key);
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(corner, {corner.x + width, corner.y + height}, ui::faded(look.colors.field, ImGui::IsItemHovered() ? 1 : 0.55f), look(3));
  const ui::FontScope font(look.heading);
  list->AddText({corner.x + look(6), corner.y + (height - ImGui::GetFontSize()) / 2}, look.colors.text, title.c_str());
  ui::draw_icon(list, folded ? ui::Icon::chevron_right : ui::Icon::chevron_down, {corner.x + width - look(18), corner.y + (height - look(10)) / 2}, look(10), look.colors.dim);
  return !folded;
}

struct Properties : Editor {
  using Editor::Editor;

  Property<std::string> search{this, "search", "", {.doc = "shows the properties whose name, doc or value has these words", .affects = Affects::nothing}};

  std::string title() const override { return "Properties"; }

  void draw(Workbench& workbench) override {
    const ui::Look& look = ui::look();
    const std::string selection = workbench.selection();
    const auto instances = workbench.instances();
    const auto selected = std::find_if(instances.begin(), instances.end(), [&](const InstanceState& each) { return each.id == selection; });
    if (selected == instances.end()) {
      ImGui::PushTextWrapPos(0);
      ui::text("Nothing is selected. Click a row of the outline, or a surface in the picture.", look.colors.dim);
      ImGui::PopTextWrapPos();
      return;
    }
    draw_header(workbench, *selected);
    std::string words = search;
    if (ui::search_field("search", words, -FLT_MIN, "Search properties")) search.set(words);
    ImGui::BeginChild("rows");
    ImGui::PushID(selection.c_str());
    draw_groups(workbench, *selected, words);
    ImGui::PopID();
    ImGui::EndChild();
  }

 private:
  static void draw_header(Workbench& workbench, const InstanceState& instance) {
    const ui::Look& look = ui::look();
    {
      const ui::FontScope font(look.heading);
      ui::text(instance.id, look.colors.text);
    }
    ui::tooltip(instance.doc);
    ImGui::SameLine(0, look(6));
    {
      const ui::FontScope font(look.mono);
      ui::text(instance.type, look.colors.label);
    }
    if (ImGui::IsItemClicked() && !instance.source.empty()) workbench.open_source(instance.source, 1);
    ui::tooltip(instance.source.empty() ? instance.doc : instance.doc + "\nA click opens its source.");
    if (!instance.known) {
      ImGui::PushTextWrapPos(0);
      ui::text("No library has this type; its values are kept as they are.", look.colors.warning);
      ImGui::PopTextWrapPos();
    }
  }

  static void draw_groups(Workbench& workbench, const InstanceState& instance, const std::string& filter) {
    const ui::Look& look = ui::look();
    const auto properties = workbench.properties(instance.id);
    std::vector<std::string> groups;
    for (const PropertyState& state : properties)
      if (std::find(groups.begin(), groups.end(), state.spec.options.group) == groups.end()) groups.push_back(state.spec.options.group);
    // What has no group comes first, without a heading.
    std::stable_partition(groups.begin(), groups.end(), [](const std::string& group) { return group.empty(); });

    const bool searching = !filter.empty();
    int shown = 0;
    const auto rows = [&](const std::string& group, bool advanced) {
      for (const PropertyState& state : properties) {
        if (state.spec.options.group != group || (state.spec.options.advanced && !searching) != advanced || !found(state, filter, workbench)) continue;
        ui::property_row(workbench, instance.id, state);
        ++shown;
      }
    };
    const auto any = [&](const std::string& group, bool advanced) {
      return std::any_of(properties.begin(), properties.end(), [&](const PropertyState& state) {
        return state.spec.options.group == group && (!advanced || state.spec.options.advanced) && found(state, filter, workbench);
      });
    };
    for (const std::string& group : groups) {
      if (!any(group, false)) continue;
      ImGui::PushID(group.c_str());
      // A search looks into folded groups, too.
      if (group.empty() || heading(ui::label_of(group)) || searching) {
        rows(group, false);
        if (!searching && any(group, true) && more()) rows(group, true);
      }
      ImGui::PopID();
    }
    if (shown == 0 && searching) ui::text("no property has these words", look.colors.dim);
    if (!instance.orphans.empty() && heading("Kept")) {
      for (const std::string& orphan : instance.orphans) {
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        ui::draw_icon(ImGui::GetWindowDrawList(), ui::Icon::question, {corner.x + look(1), corner.y + look(3)}, look(12), look.colors.dim);
        ImGui::SetCursorScreenPos({corner.x + look(16), corner.y});
        const ui::FontScope font(look.mono);
        ui::text(orphan, look.colors.dim);
        ui::tooltip("nothing declares this value now; it is kept and saved");
      }
    }
  }

  /// The fold of advanced rows. True while open.
  static bool more() {
    const ui::Look& look = ui::look();
    ImGuiStorage* storage = ImGui::GetStateStorage();
    const ImGuiID key = ImGui::GetID("more open");
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetFrameHeight();
    if (ImGui::InvisibleButton("more", {ImGui::GetContentRegionAvail().x, height})) storage->SetBool(key, !storage->GetBool(key));
    const bool open = storage->GetBool(key);
    ImDrawList* list = ImGui::GetWindowDrawList();
    ui::draw_icon(list, open ? ui::Icon::chevron_down : ui::Icon::chevron_right, {corner.x + look(1), corner.y + (height - look(10)) / 2}, look(10), look.colors.dim);
    list->AddText({corner.x + look(16), corner.y + (height - ImGui::GetFontSize()) / 2}, ImGui::IsItemHovered() ? look.colors.text : look.colors.dim, "More");
    return open;
  }
};

}  // namespace

LUMEN_PLUGIN(Properties, "editor.properties", "the properties of the selected instance, a control each")
