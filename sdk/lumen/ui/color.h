/// Colors as people see and write them; properties keep them linear.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>
#include <imgui.h>

#include <lumen/ui/edit.h>
#include <lumen/ui/number_field.h>

namespace lumen::ui {

glm::vec3 to_srgb(glm::vec3 linear);
glm::vec3 from_srgb(glm::vec3 encoded);
ImU32 packed(glm::vec3 linear, float alpha = 1);        ///< for drawing; clamped
std::string hex_of(glm::vec3 linear);                   ///< "DC3840", sRGB
std::optional<glm::vec3> color_of(std::string_view hex);  ///< linear; also with '#', or three digits

/// A swatch and its hex text. The swatch opens a picker (a visit is one edit) and is dragged onto others to copy.
Edit color_field(const char* id, glm::vec3& linear, const NumberRange& range, float width, const FieldStyle& style = {});

/// The picker alone: wheel and linear numbers. `width` in pixels.
Edit color_picker(const char* id, glm::vec3& linear, const NumberRange& range, float width);

}  // namespace lumen::ui
