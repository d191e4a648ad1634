#include <lumen/ui/transfer_function_field.h>

#include <algorithm>
#include <cmath>

#include <lumen/ui/color.h>
#include <lumen/ui/color_maps.h>
#include <lumen/ui/icons.h>
#include <lumen/ui/look.h>
#include <lumen/ui/simple_fields.h>

namespace lumen::ui {
namespace {

constexpr float curve_height = 120, hit_radius = 12;  // UI units
constexpr std::size_t most_points = 1024;

/// Between pixels and values.
struct Plot {
  ImVec2 min, max;
  glm::vec2 range;

  float pixel_x(float x) const { return min.x + (x - range.x) / (range.y - range.x) * (max.x - min.x); }
  float pixel_y(float opacity) const { return max.y - opacity * (max.y - min.y); }
  float value_x(float pixel) const { return range.x + std::clamp((pixel - min.x) / (max.x - min.x), 0.0f, 1.0f) * (range.y - range.x); }
  float opacity(float pixel) const { return std::clamp((max.y - pixel) / (max.y - min.y), 0.0f, 1.0f); }
  ImVec2 at(const TransferFunction::Point& point) const { return {pixel_x(point.x), pixel_y(point.rgba.a)}; }
};

void draw(const Plot& plot, const TransferFunction& function, int chosen, bool hovered, const FieldStyle& style) {
  const Look& it = look();
  ImDrawList* list = ImGui::GetWindowDrawList();
  field_frame(plot.min, plot.max, hovered, style);
  list->PushClipRect(plot.min, plot.max, true);
  const float column = std::max(2.0f, it(2));
  for (float x = plot.min.x; x < plot.max.x; x += column) {
    const glm::vec4 color = function.at(plot.value_x(x + column / 2));
    list->AddRectFilled({x, plot.pixel_y(color.a)}, {std::min(x + column, plot.max.x), plot.max.y}, packed(glm::vec3(color)));
    list->AddRectFilled({x, plot.max.y - it(4)}, {std::min(x + column, plot.max.x), plot.max.y}, packed(glm::vec3(color)));
  }
  for (const auto& point : function.points) list->PathLineTo(plot.at(point));
  list->PathStroke(it.colors.text, 0, std::max(1.0f, it(1.5f)));
  list->PopClipRect();
  for (std::size_t index = 0; index < function.points.size(); ++index) {
    const bool is_chosen = static_cast<int>(index) == chosen;
    list->AddCircleFilled(plot.at(function.points[index]), it(is_chosen ? 6 : 4.5f), it.colors.panel);
    list->AddCircleFilled(plot.at(function.points[index]), it(is_chosen ? 4.5f : 3), it.colors.text);
  }
}

int nearest(const Plot& plot, const TransferFunction& function, ImVec2 pixel) {
  int best = -1;
  float distance = look()(hit_radius);
  for (std::size_t index = 0; index < function.points.size(); ++index) {
    const ImVec2 place = plot.at(function.points[index]);
    const float away = std::hypot(place.x - pixel.x, place.y - pixel.y);
    if (away <= distance) {
      distance = away;
      best = static_cast<int>(index);
    }
  }
  return best;
}

/// Points keep their order: one cannot pass its neighbors.
void place(TransferFunction& function, int index, float x, float opacity) {
  auto& points = function.points;
  const auto here = static_cast<std::size_t>(index);
  const float low = index > 0 ? points[here - 1].x : function.range.x;
  const float high = here + 1 < points.size() ? points[here + 1].x : function.range.y;
  points[here].x = std::clamp(x, std::min(low, high), std::max(low, high));
  points[here].rgba.a = opacity;
}

int insert(TransferFunction& function, float x, float opacity) {
  auto& points = function.points;
  const auto after = std::upper_bound(points.begin(), points.end(), x, [](float value, const auto& point) { return value < point.x; });
  return static_cast<int>(points.insert(after, {x, glm::vec4(glm::vec3(function.at(x)), opacity)}) - points.begin());
}

Edit chosen_point(TransferFunction& function, int& chosen, float width) {
  const Look& it = look();
  Edit edit;
  auto& point = function.points[static_cast<std::size_t>(chosen)];
  const float gap = it(3), button = ImGui::GetFrameHeight(), number = (width - button - 2 * gap) / 2;
  double x = point.x, opacity = point.rgba.a;
  const Edit moved = number_field("x", x, {.min = function.range.x, .max = function.range.y}, number, {.prefix = "x"});
  ImGui::SameLine(0, gap);
  const Edit faded = number_field("opacity", opacity, {.min = 0, .max = 1}, number, {.prefix = "a"});
  if (moved.changed || faded.changed) place(function, chosen, static_cast<float>(x), static_cast<float>(opacity));
  edit |= moved;
  edit |= faded;
  ImGui::SameLine(0, gap);
  const bool removed = function.points.size() > 2 && icon_button("remove", Icon::cross, button, it.colors.label, "remove this point");
  glm::vec3 color(function.points[static_cast<std::size_t>(chosen)].rgba);
  const Edit painted = color_field("color", color, {.min = 0, .max = 1}, width);
  if (painted.changed) function.points[static_cast<std::size_t>(chosen)].rgba = glm::vec4(color, function.points[static_cast<std::size_t>(chosen)].rgba.a);
  edit |= painted;
  if (removed) {
    function.points.erase(function.points.begin() + chosen);
    chosen = -1;
    edit.changed = true;
  }
  return edit;
}

Edit range_and_maps(TransferFunction& function, float width) {
  const Look& it = look();
  Edit edit;
  const float gap = it(3), each = (width - 2 * gap) / 3;
  double low = function.range.x, high = function.range.y;
  const Edit from = number_field("from", low, {}, each, {.prefix = "from"});
  ImGui::SameLine(0, gap);
  const Edit to = number_field("to", high, {}, each, {.prefix = "to"});
  edit |= from;
  edit |= to;
  if ((from.changed || to.changed) && high > low) {
    // The points go along, so that the function keeps its shape.
    const glm::vec2 before = function.range, after(static_cast<float>(low), static_cast<float>(high));
    for (auto& point : function.points) point.x = after.x + (point.x - before.x) / (before.y - before.x) * (after.y - after.x);
    function.range = after;
  }
  ImGui::SameLine(0, gap);
  ImGui::SetNextItemWidth(each);
  if (ImGui::BeginCombo("##maps", "Map")) {
    for (const std::string_view name : color_map_names()) {
      if (ImGui::Selectable(std::string(name).c_str())) {
        function = with_colors(function, name);
        edit.changed = true;
      }
    }
    ImGui::EndCombo();
  }
  return edit;
}

}  // namespace

Edit transfer_function_field(const char* id, TransferFunction& function, float width, const FieldStyle& style) {
  const Look& it = look();
  Edit edit;
  if (function.points.size() < 2 || !(function.range.x < function.range.y)) {
    const glm::vec2 range = function.range.x < function.range.y ? function.range : glm::vec2(0, 1);
    function = {range, {{range.x, {0, 0, 0, 0}}, {range.y, {1, 1, 1, 1}}}};
  }
  ImGui::PushID(id);
  ImGui::BeginGroup();
  ImGuiStorage* storage = ImGui::GetStateStorage();
  const ImGuiID key = ImGui::GetID("chosen");
  int chosen = std::min(storage->GetInt(key, -1), static_cast<int>(function.points.size()) - 1);

  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const Plot plot{corner, {corner.x + width, corner.y + it(curve_height)}, function.range};
  ImGui::InvisibleButton("curve", {width, it(curve_height)});
  const bool hovered = ImGui::IsItemHovered();
  const ImVec2 pointer = ImGui::GetIO().MousePos;
  if (!style.locked && ImGui::IsItemActivated()) {
    chosen = nearest(plot, function, pointer);
    if (chosen < 0 && function.points.size() < most_points) {
      chosen = insert(function, plot.value_x(pointer.x), plot.opacity(pointer.y));
      edit.changed = true;
    }
    edit.active = true;
  } else if (!style.locked && ImGui::IsItemActive() && chosen >= 0) {
    edit.active = true;
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) {
      edit.cancelled = true;
    } else if (ImGui::GetIO().MouseDelta.x != 0 || ImGui::GetIO().MouseDelta.y != 0) {
      place(function, chosen, plot.value_x(pointer.x), plot.opacity(pointer.y));
      edit.changed = true;
    }
  }
  if (hovered) {
    take_keys();
    if (!style.locked && chosen >= 0 && function.points.size() > 2 && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Delete), false)) {
      function.points.erase(function.points.begin() + chosen);
      chosen = -1;
      edit.changed = true;
    }
  }
  draw(plot, function, chosen, hovered, style);
  if (!style.locked) {
    if (chosen >= 0) edit |= chosen_point(function, chosen, width);
    edit |= range_and_maps(function, width);
  }
  storage->SetInt(key, chosen);
  ImGui::EndGroup();
  ImGui::PopID();
  return edit;
}

}  // namespace lumen::ui
