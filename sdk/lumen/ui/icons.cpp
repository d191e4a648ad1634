#include <lumen/ui/icons.h>

#include <algorithm>

#include <lumen/ui/look.h>

namespace lumen::ui {

void draw_icon(ImDrawList* list, Icon icon, ImVec2 corner, float size, ImU32 color) {
  // All icons live in a unit square.
  const auto at = [&](float x, float y) { return ImVec2(corner.x + x * size, corner.y + y * size); };
  const float stroke = std::max(1.0f, size / 10);
  const auto path = [&](std::initializer_list<ImVec2> points, bool closed = false) {
    for (const ImVec2& point : points) list->PathLineTo(at(point.x, point.y));
    list->PathStroke(color, closed ? ImDrawFlags_Closed : 0, stroke);
  };
  switch (icon) {
    case Icon::none: break;
    case Icon::dot: list->AddCircleFilled(at(0.5f, 0.5f), size * 0.22f, color); break;
    case Icon::chain:
      list->AddRect(at(0.05f, 0.33f), at(0.56f, 0.67f), color, size * 0.17f, 0, stroke);
      list->AddRect(at(0.44f, 0.33f), at(0.95f, 0.67f), color, size * 0.17f, 0, stroke);
      break;
    case Icon::function:
      list->PathLineTo(at(0.78f, 0.14f));
      list->PathBezierCubicCurveTo(at(0.45f, 0.02f), at(0.56f, 0.98f), at(0.22f, 0.86f));
      list->PathStroke(color, 0, stroke);
      path({{0.32f, 0.45f}, {0.74f, 0.45f}});
      break;
    case Icon::triangle: list->AddTriangleFilled(at(0.5f, 0.1f), at(0.95f, 0.88f), at(0.05f, 0.88f), color); break;
    case Icon::question:
      list->PathArcTo(at(0.5f, 0.33f), size * 0.2f, 3.4f, 7.4f);
      list->PathLineTo(at(0.5f, 0.66f));
      list->PathStroke(color, 0, stroke);
      list->AddCircleFilled(at(0.5f, 0.86f), stroke * 0.8f, color);
      break;
    case Icon::check: path({{0.16f, 0.52f}, {0.4f, 0.76f}, {0.86f, 0.26f}}); break;
    case Icon::eye:
      list->AddCircle(at(0.5f, 0.5f), size * 0.34f, color, 0, stroke);
      list->AddCircleFilled(at(0.5f, 0.5f), size * 0.17f, color);
      break;
    case Icon::eye_off: list->AddCircle(at(0.5f, 0.5f), size * 0.34f, color, 0, stroke); break;
    case Icon::chevron_right: list->AddTriangleFilled(at(0.36f, 0.28f), at(0.7f, 0.5f), at(0.36f, 0.72f), color); break;
    case Icon::chevron_down: list->AddTriangleFilled(at(0.28f, 0.36f), at(0.72f, 0.36f), at(0.5f, 0.7f), color); break;
    case Icon::cross: path({{0.24f, 0.24f}, {0.76f, 0.76f}}); path({{0.76f, 0.24f}, {0.24f, 0.76f}}); break;
    case Icon::refresh:
      list->PathArcTo(at(0.5f, 0.5f), size * 0.34f, -0.9f, 4.0f);
      list->PathStroke(color, 0, stroke);
      path({{0.5f, 0.06f}, {0.74f, 0.22f}, {0.52f, 0.38f}});
      break;
    case Icon::plus: path({{0.5f, 0.16f}, {0.5f, 0.84f}}); path({{0.16f, 0.5f}, {0.84f, 0.5f}}); break;
    case Icon::square: list->AddRectFilled(at(0.2f, 0.2f), at(0.8f, 0.8f), color, size * 0.08f); break;
    case Icon::diamond: list->AddQuadFilled(at(0.5f, 0.08f), at(0.92f, 0.5f), at(0.5f, 0.92f), at(0.08f, 0.5f), color); break;
    case Icon::play: path({{0.26f, 0.16f}, {0.8f, 0.5f}, {0.26f, 0.84f}}, true); break;
    case Icon::disc: path({{0.5f, 0.1f}, {0.9f, 0.5f}, {0.5f, 0.9f}, {0.1f, 0.5f}}, true); break;
    case Icon::screen: path({{0.1f, 0.22f}, {0.9f, 0.22f}, {0.9f, 0.78f}, {0.1f, 0.78f}}, true); break;
    case Icon::up: path({{0.24f, 0.62f}, {0.5f, 0.36f}, {0.76f, 0.62f}}); break;
    case Icon::down: path({{0.24f, 0.38f}, {0.5f, 0.64f}, {0.76f, 0.38f}}); break;
    case Icon::folder: path({{0.08f, 0.2f}, {0.4f, 0.2f}, {0.5f, 0.34f}, {0.92f, 0.34f}, {0.92f, 0.8f}, {0.08f, 0.8f}}, true); break;
    case Icon::file: path({{0.22f, 0.1f}, {0.6f, 0.1f}, {0.8f, 0.3f}, {0.8f, 0.9f}, {0.22f, 0.9f}}, true); break;
  }
}

bool icon_button(const char* id, Icon icon, float size, ImU32 color, const char* words) {
  const Look& it = look();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const bool pressed = ImGui::InvisibleButton(id, {size, size});
  ImDrawList* list = ImGui::GetWindowDrawList();
  if (ImGui::IsItemHovered()) list->AddRectFilled(corner, {corner.x + size, corner.y + size}, it.colors.hover, it(3));
  const float inset = size * 0.18f;
  draw_icon(list, icon, {corner.x + inset, corner.y + inset}, size - 2 * inset, color);
  if (words && *words) tooltip(words);
  return pressed;
}

}  // namespace lumen::ui
