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

template <class State>
bool suits(const State& state, const std::string& accepts) {
  if (accepts == "camera") return state.camera;
  if (accepts == "light") return state.light;
  return accepts.empty() ? state.kind != Kind::view : name_of(state.kind) == accepts;
}

/// What was chosen from the open list.
struct Choosing {
  bool done = false;
  std::string id;         ///< empty: none
  std::string new_type;   ///< or an instance of this, which is yet to be added
};

/// A row of two columns. True if it was clicked, or is the first that the filter leaves and Enter was pressed.
bool row(const std::string& name, const std::string& words, bool first) {
  const Look& it = look();
  const bool pressed = ImGui::Selectable(("##" + name).c_str(), false, 0, {it(420), 0});
  record("choose/" + name);
  if (!words.empty()) tooltip(words);
  const ImVec2 corner = ImGui::GetItemRectMin();
  ImDrawList* list = ImGui::GetWindowDrawList();
  text_elided(list, corner, it(190), name, it.colors.text);
  text_elided(list, {corner.x + it(200), corner.y}, it(220), words, it.colors.dim);
  const bool entered = first && (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false) || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_KeyPadEnter), false));
  return pressed || entered;
}

/// The open list: what the session has, then what can be added to it.
Choosing choose(const Workbench& workbench, const std::string& accepts, bool with_none) {
  const Look& it = look();
  std::string& filter = look().filter;
  if (ImGui::IsWindowAppearing()) {
    filter.clear();
    ImGui::SetKeyboardFocusHere();
  }
  search_field("filter", filter, it(420), "Filter; Enter takes the first");
  Choosing choosing;
  if (with_none && filter.empty() && row("none", "", false)) choosing.done = true;
  bool first = !filter.empty();
  for (const InstanceState& instance : candidates(workbench, accepts)) {
    if (!matches(instance.id + " " + instance.type, filter)) continue;
    if (row(instance.id, instance.type, std::exchange(first, false))) choosing = {.done = true, .id = instance.id};
  }
  bool headed = false;
  for (const TypeState& type : workbench.types()) {
    if (!suits(type, accepts) || !matches(type.id + " " + type.doc + " new", filter)) continue;
    if (!std::exchange(headed, true)) text("New", it.colors.label);
    if (row(type.id, type.doc, std::exchange(first, false))) choosing = {.done = true, .new_type = type.id};
  }
  if (choosing.done) ImGui::CloseCurrentPopup();
  return choosing;
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
  std::erase_if(instances, [&](const InstanceState& instance) { return !suits(instance, accepts); });
  return instances;
}

Edit reference_field(Workbench& workbench, const char* id, std::string& reference, const std::string& accepts, float width, const FieldStyle& style) {
  Edit edit;
  ImGui::PushID(id);
  if (chip("chip", reference.empty() ? "none" : reference, reference.empty(), width, style)) ImGui::OpenPopup("choose");
  if (accept_drop(workbench, accepts, reference)) edit.changed = true;
  if (ImGui::BeginPopup("choose")) {
    if (Choosing choosing = choose(workbench, accepts, true); choosing.done) {
      edit.new_type = std::move(choosing.new_type);
      edit.changed = true;
      if (edit.new_type.empty()) reference = std::move(choosing.id);
    }
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
      if (Choosing choosing = choose(workbench, accepts, false); choosing.done) {
        edit.new_type = std::move(choosing.new_type);
        add = edit.new_type.empty();
        chosen = std::move(choosing.id);
      }
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
