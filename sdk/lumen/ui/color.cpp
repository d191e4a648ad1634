#include <lumen/ui/color.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

#include <lumen/ui/look.h>
#include <lumen/ui/simple_fields.h>
#include <lumen/ui/text_field.h>

namespace lumen::ui {

glm::vec3 to_srgb(glm::vec3 linear) {
  const auto encode = [](float c) { return c <= 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1 / 2.4f) - 0.055f; };
  return {encode(linear.r), encode(linear.g), encode(linear.b)};
}

glm::vec3 from_srgb(glm::vec3 encoded) {
  const auto decode = [](float c) { return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f); };
  return {decode(encoded.r), decode(encoded.g), decode(encoded.b)};
}

ImU32 packed(glm::vec3 linear, float alpha) {
  const glm::vec3 c = to_srgb(linear);
  return ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, alpha});
}

std::string hex_of(glm::vec3 linear) {
  const glm::vec3 c = to_srgb(linear);
  const auto byte = [](float x) { return static_cast<unsigned>(std::lround(std::clamp(x, 0.0f, 1.0f) * 255)); };
  char text[8];
  std::snprintf(text, sizeof text, "%02X%02X%02X", byte(c.r), byte(c.g), byte(c.b));
  return text;
}

std::optional<glm::vec3> color_of(std::string_view hex) {
  if (hex.starts_with('#')) hex.remove_prefix(1);
  unsigned number = 0;
  const auto [end, error] = std::from_chars(hex.data(), hex.data() + hex.size(), number, 16);
  if (error != std::errc{} || end != hex.data() + hex.size() || (hex.size() != 6 && hex.size() != 3)) return std::nullopt;
  const auto channel = [&](int index) {
    return hex.size() == 6 ? static_cast<float>(number >> (16 - 8 * index) & 255) / 255 : static_cast<float>(number >> (8 - 4 * index) & 15) / 15;
  };
  return from_srgb({channel(0), channel(1), channel(2)});
}

Edit color_picker(const char* id, glm::vec3& linear, const NumberRange& range, float width) {
  Edit edit;
  edit.active = true;
  ImGui::PushID(id);
  glm::vec3 shown = to_srgb(linear);
  ImGui::SetNextItemWidth(width);
  if (ImGui::ColorPicker3("wheel", &shown.x,
                          ImGuiColorEditFlags_PickerHueWheel | ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoLabel)) {
    linear = from_srgb(shown);
    edit.changed = true;
  }
  text("linear", look().colors.dim);
  edit |= vector_field("linear", {&linear.x, 3}, range, width, "RGB");
  ImGui::PopID();
  return edit;
}

Edit color_field(const char* id, glm::vec3& linear, const NumberRange& range, float width, const FieldStyle& style) {
  constexpr const char* payload = "lumen color";
  const Look& it = look();
  Edit edit;
  ImGui::PushID(id);
  ImGui::BeginGroup();
  const float height = ImGui::GetFrameHeight(), swatch = std::min(width * 0.4f, it(56));
  const ImVec2 corner = ImGui::GetCursorScreenPos(), end(corner.x + swatch, corner.y + height);
  const bool pressed = ImGui::InvisibleButton("swatch", {swatch, height});
  ImGui::GetWindowDrawList()->AddRectFilled(corner, end, packed(linear, style.dimmed ? 0.5f : 1), it(3));
  if (it.colors.bordered || ImGui::IsItemHovered()) ImGui::GetWindowDrawList()->AddRect(corner, end, it.colors.border, it(3));
  if (ImGui::BeginDragDropSource(ImGuiDragDropFlags_SourceNoDisableHover)) {
    ImGui::SetDragDropPayload(payload, &linear, sizeof linear);
    ImGui::TextUnformatted(hex_of(linear).c_str());
    ImGui::EndDragDropSource();
  }
  if (!style.locked && ImGui::BeginDragDropTarget()) {
    if (const ImGuiPayload* dropped = ImGui::AcceptDragDropPayload(payload); dropped && dropped->DataSize == sizeof linear) {
      linear = *static_cast<const glm::vec3*>(dropped->Data);
      edit.changed = true;
    }
    ImGui::EndDragDropTarget();
  }
  if (pressed && !style.locked) ImGui::OpenPopup("picker");
  if (ImGui::BeginPopup("picker")) {
    edit |= color_picker("color", linear, range, it(220));
    ImGui::EndPopup();
  }
  ImGui::SameLine(0, it(3));
  std::string hex = hex_of(linear);
  if (text_field("##hex", hex, width - swatch - it(3), "", true) && !style.locked) {
    if (const auto typed = color_of(hex)) {
      linear = *typed;
      edit.changed = true;
    } else {
      look().notice = "'" + hex + "' is no color; type six hex digits, such as DC3840";
    }
  }
  ImGui::EndGroup();
  ImGui::PopID();
  return edit;
}

}  // namespace lumen::ui
