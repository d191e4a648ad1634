#include <lumen/ui/reference_field.h>

#include <algorithm>
#include <cfloat>
#include <utility>

#include <lumen/ui/icons.h>
#include <lumen/ui/look.h>
#include <lumen/ui/text_field.h>

namespace lumen::ui {
namespace {

constexpr const char* instance_payload = "lumen instance";

bool fits(const InstanceState& instance, const std::string& accepts) {
  if (accepts == "camera") return instance.camera;
  if (accepts == "light") return instance.light;
  return accepts.empty() ? instance.kind != Kind::view : name_of(instance.kind) == accepts;
}

/// The open list. True if `chosen` is the answer; empty = none.
bool choose(const Workbench& workbench, const std::string& accepts, bool with_none, std::string& chosen) {
  const Look& it = look();
  std::string& filter = look().filter;
  if (ImGui::IsWindowAppearing()) {
    filter.clear();
    ImGui::SetKeyboardFocusHere();
  }
  search_field("filter", filter, it(240), "Filter");
  bool answered = false;
  if (with_none && filter.empty() && ImGui::Selectable("none")) {
    chosen.clear();
    answered = true;
  }
  const auto instances = candidates(workbench, accepts);
  for (const InstanceState& instance : instances) {
    if (!matches(instance.id + " " + instance.type, filter)) continue;
    if (ImGui::Selectable((instance.id + "##" + instance.id).c_str())) {
      chosen = instance.id;
      answered = true;
    }
    ImGui::SameLine(it(120));
    text(instance.type, it.colors.dim);
  }
  if (instances.empty()) text("nothing of this kind is in the session; add it with Shift+A", it.colors.dim);
  if (answered) ImGui::CloseCurrentPopup();
  return answered;
}

/// A field that shows an id. True if it was clicked.
bool chip(const char* id, const std::string& words, bool empty, float width, const FieldStyle& style) {
  const Look& it = look();
  const float height = ImGui::GetFrameHeight();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const bool pressed = ImGui::InvisibleButton(id, {width, height});
  field_frame(corner, {corner.x + width, corner.y + height}, ImGui::IsItemHovered(), style);
  const float top = corner.y + (height - ImGui::GetFontSize()) / 2;
  ImDrawList* list = ImGui::GetWindowDrawList();
  if (!empty) draw_icon(list, Icon::diamond, {corner.x + it(8), corner.y + (height - it(10)) / 2}, it(10), it.colors.label);
  const ImU32 color = empty ? it.colors.dim : !style.source.empty() ? it.colors.driven : it.colors.text;
  text_elided(list, {corner.x + it(empty ? 8 : 24), top}, width - it(32), words, faded(color, style.dimmed ? 0.6f : 1));
  return pressed && !style.locked;
}

bool accept_drop(const Workbench& workbench, const std::string& accepts, std::string& chosen) {
  bool dropped = false;
  if (!ImGui::BeginDragDropTarget()) return false;
  if (const ImGuiPayload* payload = ImGui::AcceptDragDropPayload(instance_payload)) {
    const std::string id(static_cast<const char*>(payload->Data), static_cast<std::size_t>(payload->DataSize));
    const auto fitting = candidates(workbench, accepts);
    dropped = std::any_of(fitting.begin(), fitting.end(), [&](const InstanceState& instance) { return instance.id == id; });
    if (dropped) chosen = id;
    else look().notice = id + " does not fit here; this takes " + (accepts.empty() ? "an instance" : accepts);
  }
  ImGui::EndDragDropTarget();
  return dropped;
}

}  // namespace

std::vector<InstanceState> candidates(const Workbench& workbench, const std::string& accepts) {
  auto instances = workbench.instances();
  std::erase_if(instances, [&](const InstanceState& instance) { return !fits(instance, accepts); });
  return instances;
}

Edit reference_field(Workbench& workbench, const char* id, std::string& reference, const std::string& accepts, float width, const FieldStyle& style) {
  Edit edit;
  ImGui::PushID(id);
  if (chip("chip", reference.empty() ? "none" : reference, reference.empty(), width, style)) ImGui::OpenPopup("choose");
  if (accept_drop(workbench, accepts, reference)) edit.changed = true;
  if (ImGui::BeginPopup("choose")) {
    edit.changed |= choose(workbench, accepts, true, reference);
    ImGui::EndPopup();
  }
  ImGui::PopID();
  return edit;
}

Edit references_field(Workbench& workbench, const char* id, std::vector<std::string>& references, const std::string& accepts, float width,
                      const FieldStyle& style) {
  const Look& it = look();
  Edit edit;
  ImGui::PushID(id);
  ImGui::BeginGroup();
  const float button = ImGui::GetFrameHeight(), gap = it(1);
  int gone = -1, raised = -1;
  for (std::size_t index = 0; index < references.size(); ++index) {
    ImGui::PushID(static_cast<int>(index));
    if (chip("chip", references[index], false, width - 3 * (button + gap), style)) workbench.select(references[index]);
    tooltip("shows its properties");
    ImGui::SameLine(0, gap);
    const std::string enabled = references[index] + ".enabled";
    const auto state = workbench.property(enabled);
    const bool on = !state || !std::holds_alternative<bool>(state->value) || std::get<bool>(state->value);
    if (icon_button("eye", on ? Icon::eye : Icon::eye_off, button, on ? it.colors.label : it.colors.dim, on ? "disable it" : "enable it") && state)
      workbench.set(enabled, Value(!on));
    ImGui::SameLine(0, gap);
    if (icon_button("up", Icon::up, button, index > 0 ? it.colors.label : faded(it.colors.dim, 0.4f), "move up") && index > 0) raised = static_cast<int>(index);
    ImGui::SameLine(0, gap);
    if (icon_button("remove", Icon::cross, button, it.colors.label, "take it out of the list")) gone = static_cast<int>(index);
    ImGui::PopID();
  }
  if (raised > 0) std::swap(references[static_cast<std::size_t>(raised)], references[static_cast<std::size_t>(raised) - 1]);
  if (gone >= 0) references.erase(references.begin() + gone);
  edit.changed = raised > 0 || gone >= 0;
  if (!style.locked) {
    if (chip("add", references.empty() ? "none; add one" : "add one", true, width, {})) ImGui::OpenPopup("choose");
    std::string chosen;
    bool add = accept_drop(workbench, accepts, chosen);
    if (ImGui::BeginPopup("choose")) {
      add |= choose(workbench, accepts, false, chosen);
      ImGui::EndPopup();
    }
    if (add && std::find(references.begin(), references.end(), chosen) == references.end()) {
      references.push_back(chosen);
      edit.changed = true;
    }
  }
  ImGui::EndGroup();
  ImGui::PopID();
  return edit;
}

void data_chip(const PropertyState& state, float width) {
  const Look& it = look();
  const auto* data = std::get_if<DataPointer>(&state.value);
  std::string words = state.data_state.empty() ? "none" : state.data_state;
  if (data && *data) words = (*data)->summary();
  const float height = ImGui::GetFrameHeight();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("data", {width, height});
  FieldStyle style;
  style.failed = !state.error.empty() || (state.data_state != "ready" && state.data_state != "pending" && !state.data_state.empty());
  field_frame(corner, {corner.x + width, corner.y + height}, false, style);
  const ImU32 color = state.link.empty() ? it.colors.text : it.colors.driven;
  const FontScope mono(it.mono);
  const float top = corner.y + (height - ImGui::GetFontSize()) / 2;
  text_elided(ImGui::GetWindowDrawList(), {corner.x + it(8), top}, width - it(16), state.link.empty() ? words : state.link, color);
}

}  // namespace lumen::ui
