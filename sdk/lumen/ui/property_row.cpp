#include <lumen/ui/property_row.h>

#include <algorithm>
#include <vector>

#include <imgui_internal.h>

#include <lumen/ui/look.h>
#include <lumen/ui/property_field.h>
#include <lumen/ui/property_menu.h>
#include <lumen/ui/text_field.h>

namespace lumen::ui {
namespace {

constexpr float mark_width = 14, label_share = 0.4f;

ImU32 mark_color(const PropertyState& state) {
  const Palette& colors = look().colors;
  if (!state.error.empty()) return colors.error;
  return state.link.empty() ? colors.text : colors.driven;
}

ImU32 label_color(const PropertyState& state) {
  const Palette& colors = look().colors;
  if (!state.no_effect.empty()) return faded(colors.dim, 0.8f);
  return state.set || !state.link.empty() ? colors.text : colors.label;
}

std::string written_range(const PropertyOptions& options, bool integer) {
  const auto end = [&](double value) { return written(value, integer); };
  const bool low = options.min > -1e30, high = options.max < 1e30;
  if (low && high) return end(options.min) + " to " + end(options.max);
  if (low) return "at least " + end(options.min);
  return high ? "at most " + end(options.max) : "";
}

void fill_tooltip(const Workbench& workbench, const std::string& path, const PropertyState& state) {
  const Palette& colors = look().colors;
  const PropertySpec& spec = state.spec;
  if (!spec.options.doc.empty()) text(spec.options.doc, colors.text);
  {
    const FontScope mono(look().mono);
    text(path + "  " + std::string(name_of(spec.type)), colors.dim);
  }
  std::string facts = written_range(spec.options, spec.type == ValueType::integer);
  if (!spec.options.unit.empty()) facts += (facts.empty() ? "" : " ") + spec.options.unit;
  if (!spec.output && spec.type != ValueType::data) facts += (facts.empty() ? "default " : ", default ") + workbench.to_json(spec.default_value).substr(0, 80);
  if (!facts.empty()) text(facts, colors.label);
  if (const auto* data = std::get_if<DataPointer>(&state.value); data && *data) text((*data)->summary(), colors.label);
  if (!state.link.empty()) text("driven by " + state.link + (state.expression.empty() ? "" : " as " + state.expression), colors.driven);
  if (!state.no_effect.empty()) text(state.no_effect, colors.warning);
  if (!state.error.empty()) text(state.error, colors.error);
}

/// Reset, copy and paste by keys, while the pointer is on the row and nothing is typed.
void keys_of_row(Workbench& workbench, const std::string& path, const PropertyState& state) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.WantTextInput) return;
  take_keys();
  const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), false); };
  if (pressed(ImGuiKey_Backspace) && state.set) workbench.reset(path);
  if (io.KeyCtrl && io.KeyShift && pressed(ImGuiKey_C)) ImGui::SetClipboardText(path.c_str());
  else if (io.KeyCtrl && pressed(ImGuiKey_C)) copy_value(workbench, state);
  else if (io.KeyCtrl && pressed(ImGuiKey_V)) paste_value(workbench, path, state);
}

void label(Workbench& workbench, const std::string& path, const PropertyState& state, ImVec2 corner, float width) {
  const Look& it = look();
  const float height = ImGui::GetFrameHeight();
  const float icon = it(10);
  ImDrawList* list = ImGui::GetWindowDrawList();
  draw_icon(list, mark_of(state), {corner.x + it(1), corner.y + (height - icon) / 2}, icon, mark_color(state));
  ImGui::InvisibleButton("label", {it(mark_width) + width, height});
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0) && state.set) workbench.reset(path);
  if (begin_tooltip()) {
    fill_tooltip(workbench, path, state);
    end_tooltip();
  }
  text_elided(list, {corner.x + it(mark_width + 2), corner.y + (height - ImGui::GetFontSize()) / 2}, width - it(4), label_of(state.spec.id), label_color(state));
}

void note_beneath(std::string_view words, float indent, ImU32 color) {
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + indent);
  ImGui::PushTextWrapPos(0);
  text(words, color);
  ImGui::PopTextWrapPos();
}

/// A field for what drives it, while its formula is being edited.
void formula(Workbench& workbench, const std::string& path, const PropertyState& state, float width) {
  std::string expression = state.expression;
  if (!text_field("##formula", expression, width, "x", true)) return;
  try {
    workbench.link(path, state.link, expression);
  } catch (const Error& error) {
    look().notice = error.what();
  }
}

}  // namespace

Icon mark_of(const PropertyState& state) {
  if (!state.error.empty()) return Icon::triangle;
  if (!state.expression.empty()) return Icon::function;
  if (!state.link.empty()) return Icon::chain;
  return state.set ? Icon::dot : Icon::none;
}

std::string label_of(const std::string& property) {
  std::string words = property;
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

void property_row(Workbench& workbench, const std::string& instance, const PropertyState& state) {
  const Look& it = look();
  const std::string path = instance + "." + state.spec.id;
  ImGui::PushID(state.spec.id.c_str());
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float total = ImGui::GetContentRegionAvail().x, mark = it(mark_width);
  const float label_width = std::max(it(60), (total - mark) * label_share), field_width = total - mark - label_width;

  label(workbench, path, state, corner, label_width);
  record("label:" + path);
  ImGui::SetCursorScreenPos({corner.x + mark + label_width, corner.y});
  ImGui::BeginGroup();
  Value value = state.value;
  carry_out(workbench, path, property_field(workbench, state, value, field_width), value);
  ImGui::EndGroup();
  record(path);
  if (begin_tooltip()) {
    fill_tooltip(workbench, path, state);
    end_tooltip();
  }
  const float bottom = std::max(ImGui::GetItemRectMax().y, corner.y + ImGui::GetFrameHeight());
  ImGui::SetCursorScreenPos({corner.x, bottom});
  ImGui::Dummy({0, 0});
  if (!state.expression.empty()) {
    ImGui::SetCursorScreenPos({corner.x + mark + label_width, ImGui::GetCursorScreenPos().y});
    formula(workbench, path, state, field_width);
  }
  if (!state.no_effect.empty()) note_beneath(state.no_effect, mark + label_width, it.colors.dim);
  if (!state.error.empty()) note_beneath(state.error, mark + label_width, it.colors.error);

  const bool on_row = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(corner, {corner.x + total, bottom});
  if (on_row) keys_of_row(workbench, path, state);
  if (on_row && ImGui::IsMouseReleased(1) && !it.swallow_right) ImGui::OpenPopup("menu");
  property_menu(workbench, path, state);
  ImGui::PopID();
}

}  // namespace lumen::ui
