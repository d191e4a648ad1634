#include <lumen/ui/property_menu.h>

#include <algorithm>

#include <imgui.h>

#include <lumen/ui/color.h>
#include <lumen/ui/look.h>
#include <lumen/ui/text_field.h>

namespace lumen::ui {
namespace {

std::string clipboard() {
  constexpr std::size_t most = 1 << 16;
  const char* text = ImGui::GetClipboardText();
  std::string content = text ? text : "";
  return content.size() <= most ? content : std::string();
}

void try_link(Workbench& workbench, const std::string& path, const std::string& source, const std::string& expression) {
  try {
    workbench.link(path, source, expression);
  } catch (const Error& error) {
    look().notice = error.what();
  }
}

/// "1 0 0 0 ..." -> "[1,0,0,0,...]"
std::string as_list(std::string numbers) {
  std::replace_if(numbers.begin(), numbers.end(), [](char c) { return c == '\n' || c == '\t' || c == ';' || c == ','; }, ' ');
  std::string list = "[";
  bool gap = false;
  for (const char c : numbers) {
    if (c == ' ') { gap = list.size() > 1; continue; }
    if (gap) list += ',';
    gap = false;
    list += c;
  }
  return list + "]";
}

void link_menu(Workbench& workbench, const std::string& path, const PropertyState& state) {
  if (!ImGui::BeginMenu("Link to...", !state.spec.output)) return;
  const Look& it = look();
  std::string& filter = look().filter;
  if (ImGui::IsWindowAppearing()) {
    filter.clear();
    ImGui::SetKeyboardFocusHere();
  }
  search_field("filter", filter, it(260), "Filter");
  const auto sources = workbench.linkable(path);
  ImGui::BeginChild("sources", {it(260), it(300)});
  for (const std::string& source : sources) {
    if (!matches(source, filter)) continue;
    if (ImGui::Selectable(source.c_str())) {
      try_link(workbench, path, source, "");
      ImGui::CloseCurrentPopup();
    }
  }
  if (sources.empty()) text("no property converts to this one without a cycle", it.colors.dim);
  ImGui::EndChild();
  ImGui::EndMenu();
}

}  // namespace

void copy_value(const Workbench& workbench, const PropertyState& state) {
  if (state.spec.type != ValueType::data) ImGui::SetClipboardText(workbench.to_json(state.value).c_str());
}

void paste_value(Workbench& workbench, const std::string& path, const PropertyState& state) {
  const std::string content = clipboard();
  try {
    if (state.spec.type == ValueType::color) {
      if (const auto color = color_of(content)) {
        workbench.set(path, Color(*color));
        return;
      }
    }
    const bool plain_numbers = content.find_first_not_of("0123456789.+-eE ,;\t\n") == std::string::npos;
    const bool list = state.spec.type == ValueType::mat4 || component_count(state.spec.type) > 1;
    workbench.set(path, workbench.from_json(path, list && plain_numbers ? as_list(content) : content));
  } catch (const Error& error) {
    look().notice = error.what();
  }
}

void property_menu(Workbench& workbench, const std::string& path, const PropertyState& state) {
  if (!ImGui::BeginPopup("menu")) return;
  const bool linked = !state.link.empty(), settable = !state.spec.output;
  if (ImGui::MenuItem("Reset", "Backspace", false, state.set)) workbench.reset(path);
  ImGui::Separator();
  link_menu(workbench, path, state);
  const std::string copied = clipboard();
  const bool is_path = copied.size() < 130 && copied.find('.') != std::string::npos && copied.find_first_of(" \n[{\"") == std::string::npos;
  if (ImGui::MenuItem("Paste as link", nullptr, false, settable && is_path)) try_link(workbench, path, copied, "");
  if (ImGui::MenuItem("Edit expression", nullptr, false, linked && state.expression.empty())) try_link(workbench, path, state.link, "x");
  if (ImGui::MenuItem("Unlink", nullptr, false, linked)) workbench.unlink(path);
  if (ImGui::MenuItem("Go to source", nullptr, false, linked)) workbench.select(state.link.substr(0, state.link.find('.')));
  ImGui::Separator();
  if (ImGui::MenuItem("Copy value", "Ctrl+C", false, state.spec.type != ValueType::data)) copy_value(workbench, state);
  if (ImGui::MenuItem("Paste value", "Ctrl+V", false, settable)) paste_value(workbench, path, state);
  if (ImGui::MenuItem("Copy path", "Ctrl+Shift+C")) ImGui::SetClipboardText(path.c_str());
  ImGui::EndPopup();
}

}  // namespace lumen::ui
