#include <lumen/ui/space_fields.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <lumen/ui/icons.h>
#include <lumen/ui/look.h>
#include <lumen/ui/simple_fields.h>

namespace lumen::ui {
namespace {

constexpr float snap_degrees = 15;

/// Follows the pointer over the ball: the point under it stays under it.
Edit turn_ball(glm::quat& rotation, ImVec2 center, float radius) {
  Edit edit;
  const ImGuiIO& io = ImGui::GetIO();
  if (!ImGui::IsItemActive()) return edit;
  edit.active = true;
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false) || ImGui::IsMouseClicked(1)) {
    look().swallow_right = true;
    edit.cancelled = true;
    return edit;
  }
  if (io.MouseDelta.x == 0 && io.MouseDelta.y == 0) return edit;
  const auto on_ball = [&](ImVec2 pixel) {
    const glm::vec2 p((pixel.x - center.x) / radius, (center.y - pixel.y) / radius);
    const float squared = glm::dot(p, p);
    return squared <= 0.5f ? glm::normalize(glm::vec3(p, std::sqrt(1 - squared))) : glm::normalize(glm::vec3(p, 0.5f / std::sqrt(squared)));
  };
  const glm::vec3 from = on_ball({io.MousePos.x - io.MouseDelta.x, io.MousePos.y - io.MouseDelta.y}), to = on_ball(io.MousePos);
  rotation = glm::normalize(glm::quat(from, to) * rotation);
  if (io.KeyCtrl) rotation = rotation_of(glm::round(euler_of(rotation) / snap_degrees) * snap_degrees);
  edit.changed = true;
  return edit;
}

}  // namespace

glm::vec3 euler_of(const glm::quat& rotation) {
  const glm::mat3 m = glm::mat3_cast(rotation);
  const float sine = std::clamp(-m[0][2], -1.0f, 1.0f);
  const float y = std::asin(sine);
  // Looking along an axis, x and z turn about the same one: x takes it all.
  if (std::abs(sine) > 0.99999f) return glm::degrees(glm::vec3(std::atan2(-m[2][1], m[1][1]), y, 0));
  return glm::degrees(glm::vec3(std::atan2(m[1][2], m[2][2]), y, std::atan2(m[0][1], m[0][0])));
}

glm::quat rotation_of(glm::vec3 degrees) {
  const glm::vec3 angle = glm::radians(degrees);
  return glm::normalize(glm::angleAxis(angle.z, glm::vec3(0, 0, 1)) * glm::angleAxis(angle.y, glm::vec3(0, 1, 0)) *
                        glm::angleAxis(angle.x, glm::vec3(1, 0, 0)));
}

Edit rotation_field(const char* id, glm::quat& rotation, float width, const FieldStyle& style) {
  const Look& it = look();
  Edit edit;
  ImGui::PushID(id);
  ImGui::BeginGroup();
  const float size = it(56), radius = size / 2;
  const ImVec2 corner = ImGui::GetCursorScreenPos(), center(corner.x + radius, corner.y + radius);
  ImGui::InvisibleButton("ball", {size, size});
  if (!style.locked) edit |= turn_ball(rotation, center, radius);
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddCircleFilled(center, radius, ImGui::IsItemHovered() ? it.colors.hover : it.colors.field);
  constexpr std::array names = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    glm::vec3 unit(0);
    unit[axis] = 1;
    const glm::vec3 tip = rotation * unit;
    const ImVec2 end(center.x + tip.x * radius * 0.75f, center.y - tip.y * radius * 0.75f);
    const ImU32 color = tip.z >= 0 ? it.colors.text : it.colors.dim;
    list->AddLine(center, end, color, std::max(1.0f, it(1.5f)));
    list->AddText({end.x + it(1), end.y - it(10)}, color, names[static_cast<std::size_t>(axis)]);
  }
  ImGui::SameLine(0, it(6));
  glm::vec3 angles = euler_of(rotation);
  const NumberRange range{.min = -180, .max = 180, .step = snap_degrees};
  FieldStyle part = style;
  part.unit = "\xC2\xB0";
  const Edit typed = vector_field("angles", {&angles.x, 3}, range, std::min(width - size - it(6), it(199)), "xyz", part);
  if (typed.changed) rotation = rotation_of(angles);
  edit |= typed;
  ImGui::EndGroup();
  ImGui::PopID();
  return edit;
}

Edit matrix_field(const char* id, glm::mat4& matrix, float width, const FieldStyle& style) {
  const Look& it = look();
  Edit edit;
  ImGui::PushID(id);
  ImGui::BeginGroup();
  ImGuiStorage* storage = ImGui::GetStateStorage();
  const ImGuiID key = ImGui::GetID("open");
  const bool open = storage->GetBool(key);
  if (icon_button("fold", open ? Icon::chevron_down : Icon::chevron_right, ImGui::GetFrameHeight(), it.colors.label, "16 numbers, row by row"))
    storage->SetBool(key, !open);
  ImGui::SameLine(0, it(3));
  ImGui::AlignTextToFramePadding();
  text(matrix == glm::mat4(1) ? "identity" : "4 x 4", it.colors.dim);
  if (open) {
    const float gap = it(3), each = (width - 3 * gap) / 4;
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 4; ++column) {
        if (column > 0) ImGui::SameLine(0, gap);
        ImGui::PushID(row * 4 + column);
        edit |= number_field("entry", matrix[column][row], {}, each, style);
        ImGui::PopID();
      }
    }
  }
  ImGui::EndGroup();
  ImGui::PopID();
  return edit;
}

}  // namespace lumen::ui
