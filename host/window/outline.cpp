#include "window/outline.h"

#include <algorithm>
#include <cfloat>
#include <set>

#include <imgui.h>

#include <lumen/ui/icons.h>
#include <lumen/ui/look.h>
#include <lumen/ui/text_field.h>

namespace lumenshop {
namespace {

using lumen::InstanceState;
using lumen::Kind;
using lumen::ui::Icon;

Icon icon_of(const InstanceState& instance) {
  switch (instance.kind) {
    case Kind::view: return Icon::screen;
    case Kind::importer: case Kind::exporter: case Kind::filter: return Icon::play;
    case Kind::interactor: return Icon::disc;
    case Kind::ambient: case Kind::diffuse: case Kind::specular: case Kind::opacity: case Kind::splitter: return Icon::diamond;
    default: return Icon::square;
  }
}

bool is_data(Kind kind) { return kind == Kind::importer || kind == Kind::filter || kind == Kind::exporter; }
bool is_part(Kind kind) { return kind == Kind::ambient || kind == Kind::diffuse || kind == Kind::specular || kind == Kind::opacity || kind == Kind::splitter; }

/// Which instances a view refers to, in the order of its properties.
std::vector<std::string> members(const lumen::Workbench& workbench, const std::string& view) {
  std::vector<std::string> ids;
  const auto add = [&](const std::string& id) {
    if (!id.empty() && std::find(ids.begin(), ids.end(), id) == ids.end()) ids.push_back(id);
  };
  for (const auto& property : workbench.properties(view)) {
    if (const auto* one = std::get_if<lumen::Reference>(&property.value)) add(one->id);
    if (const auto* many = std::get_if<lumen::References>(&property.value))
      for (const std::string& id : many->ids) add(id);
  }
  return ids;
}

ImU32 badge_color(const std::string& badge) {
  const lumen::ui::Palette& colors = lumen::ui::look().colors;
  if (badge == "building") return colors.driven;
  return badge.starts_with("kept") ? colors.warning : colors.done;
}

Icon badge_icon(const std::string& badge) {
  if (badge == "building") return Icon::refresh;
  return badge.starts_with("kept") ? Icon::triangle : Icon::check;
}

}  // namespace

bool Outline::heading(const std::string& title) {
  const lumen::ui::Look& look = lumen::ui::look();
  ImGuiStorage* storage = ImGui::GetStateStorage();
  const ImGuiID key = ImGui::GetID((title + " folded").c_str());
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float height = look(21);
  if (ImGui::InvisibleButton(title.c_str(), {ImGui::GetContentRegionAvail().x, height})) storage->SetBool(key, !storage->GetBool(key));
  const bool folded = storage->GetBool(key);
  ImDrawList* list = ImGui::GetWindowDrawList();
  lumen::ui::draw_icon(list, folded ? Icon::chevron_right : Icon::chevron_down, {corner.x, corner.y + (height - look(10)) / 2}, look(10), look.colors.label);
  list->AddText({corner.x + look(19), corner.y + (height - ImGui::GetFontSize()) / 2}, look.colors.text, title.c_str());
  return !folded;
}

void Outline::row(lumen::Workbench& workbench, const InstanceState& instance, int depth, const Actions& actions) {
  const lumen::ui::Look& look = lumen::ui::look();
  ImGui::PushID(instance.id.c_str());
  ImGui::PushID(depth);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = look(21), eye = look(18);
  const bool selected = workbench.selection() == instance.id;
  const bool pressed = ImGui::InvisibleButton("row", {width - eye - look(2), height});
  const bool hovered = ImGui::IsItemHovered();
  lumen::ui::record(instance.id);
  ImDrawList* list = ImGui::GetWindowDrawList();
  if (selected || hovered) {
    const float inset = look(5);
    list->AddRectFilled({corner.x - inset, corner.y}, {corner.x + width + inset, corner.y + height}, selected ? look.colors.selection : look.colors.hover, look(3));
  }
  if (ImGui::BeginDragDropSource()) {
    ImGui::SetDragDropPayload("lumen instance", instance.id.data(), instance.id.size());
    ImGui::TextUnformatted(instance.id.c_str());
    ImGui::EndDragDropSource();
  }
  if (pressed) workbench.select(instance.id);
  if (hovered && ImGui::IsMouseDoubleClicked(0) && instance.kind != Kind::view) renaming_ = instance.id;
  if (lumen::ui::begin_tooltip()) {
    lumen::ui::text(instance.type, look.colors.dim);
    if (!instance.doc.empty()) lumen::ui::text(instance.doc, look.colors.text);
    if (!instance.summary.empty()) lumen::ui::text(instance.summary, look.colors.label);
    if (instance.generation > 0) lumen::ui::text("generation " + std::to_string(instance.generation), look.colors.dim);
    lumen::ui::end_tooltip();
  }

  const float top = corner.y + (height - ImGui::GetFontSize()) / 2;
  const float indent = look(depth > 0 ? 14.0f : 0.0f);
  const ImU32 color = !instance.known ? look.colors.warning : instance.enabled ? look.colors.text : look.colors.dim;
  lumen::ui::draw_icon(list, icon_of(instance), {corner.x + indent, corner.y + (height - look(10)) / 2}, look(10), look.colors.label);
  // A badge has a glyph and a word, never a color alone.
  float right = corner.x + width - eye - look(8);
  const std::string remark = !instance.badge.empty() ? instance.badge : !instance.known ? "unknown" : is_data(instance.kind) ? instance.summary : "";
  if (!remark.empty()) {
    const ImU32 remark_color = instance.badge.empty() ? look.colors.dim : badge_color(instance.badge);
    const float room = std::min(ImGui::CalcTextSize(remark.c_str()).x, width * 0.5f);
    lumen::ui::text_elided(list, {right - room, top}, room + 1, remark, remark_color);
    right -= room + look(8);
    if (!instance.badge.empty()) {
      lumen::ui::draw_icon(list, badge_icon(instance.badge), {right - look(7), corner.y + (height - look(11)) / 2}, look(11), remark_color);
      right -= look(14);
    }
  }
  const float name_x = corner.x + indent + look(16);
  if (renaming_ == instance.id && depth >= 0) {
    ImGui::SetCursorScreenPos({name_x, corner.y - look(2)});
    if (!ImGui::IsAnyItemActive()) ImGui::SetKeyboardFocusHere();
    std::string name = instance.id;
    const bool finished = lumen::ui::text_field("##name", name, right - name_x, "", false);
    if (finished) actions.rename(instance.id, name);
    if (finished || ImGui::IsItemDeactivated()) renaming_.clear();
  } else {
    lumen::ui::text_elided(list, {name_x, top}, right - name_x, instance.id, color);
  }
  ImGui::SetCursorScreenPos({corner.x + width - eye, corner.y + (height - eye) / 2});
  if (instance.kind != Kind::view && instance.known &&
      lumen::ui::icon_button("eye", instance.enabled ? Icon::eye : Icon::eye_off, eye, instance.enabled ? look.colors.label : look.colors.dim,
                             instance.enabled ? "disable it: frees its GPU memory, keeps its values (H)" : "enable it (H)"))
    workbench.set(instance.id + ".enabled", lumen::Value(!instance.enabled));
  ImGui::SetCursorScreenPos({corner.x, corner.y + height});
  ImGui::Dummy({0, 0});
  ImGui::PopID();
  ImGui::PopID();
}

void Outline::draw(lumen::Workbench& workbench, const Actions& actions) {
  const lumen::ui::Look& look = lumen::ui::look();
  {
    const lumen::ui::FontScope font(look.heading);
    lumen::ui::text("Session", look.colors.text);
  }
  ImGui::SameLine(ImGui::GetContentRegionMax().x - look(74));
  if (lumen::ui::icon_button("add", Icon::plus, ImGui::GetFontSize(), look.colors.label, "add an instance (Shift+A)")) actions.add();
  ImGui::SameLine(0, look(6));
  lumen::ui::text("Shift A", look.colors.dim);
  lumen::ui::search_field("filter", filter_, -FLT_MIN, "Filter");

  ImGui::BeginChild("rows");
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, look(2)));
  const auto instances = workbench.instances();
  const auto passes = [&](const InstanceState& instance) { return lumen::ui::matches(instance.id + " " + instance.type, filter_); };
  const auto find = [&](const std::string& id) { return std::find_if(instances.begin(), instances.end(), [&](const InstanceState& each) { return each.id == id; }); };
  std::set<std::string> shown;
  for (const InstanceState& view : instances) {
    if (view.kind != Kind::view) continue;
    if (passes(view)) row(workbench, view, 0, actions);
    for (const std::string& id : members(workbench, view.id)) {
      const auto member = find(id);
      if (member == instances.end()) continue;
      shown.insert(id);
      if (passes(*member)) row(workbench, *member, 1, actions);
    }
  }
  const auto section = [&](const char* title, auto belongs) {
    std::vector<const InstanceState*> rows;
    for (const InstanceState& instance : instances)
      if (instance.kind != Kind::view && !shown.contains(instance.id) && belongs(instance) && passes(instance)) rows.push_back(&instance);
    if (rows.empty() || !heading(title)) return;
    for (const InstanceState* instance : rows) row(workbench, *instance, 1, actions);
  };
  section("data", [](const InstanceState& instance) { return is_data(instance.kind); });
  section("parts", [](const InstanceState& instance) { return is_part(instance.kind); });
  section("unused", [](const InstanceState& instance) { return !is_data(instance.kind) && !is_part(instance.kind); });
  ImGui::PopStyleVar();
  ImGui::EndChild();
}

}  // namespace lumenshop
