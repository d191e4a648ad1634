#include <lumen/ui/palette.h>

#include <algorithm>
#include <cmath>

namespace lumen::ui {
namespace {

constexpr ImU32 rgb(unsigned hex) { return IM_COL32(hex >> 16 & 255, hex >> 8 & 255, hex & 255, 255); }

// Contrasts on panel and field are asserted by the tests.
constexpr Palette dark = {
    .canvas = rgb(0x161616), .panel = rgb(0x242424), .field = rgb(0x343434), .hover = rgb(0x404040),
    .text = rgb(0xECECEC), .label = rgb(0xBDBDBD), .dim = rgb(0xA0A0A0),
    .driven = rgb(0x56B4E9), .done = rgb(0x8FD9A8), .warning = rgb(0xF2D35B), .error = rgb(0xFF7355),
    .border = rgb(0x707070), .selection = rgb(0x2B4A63), .focus = rgb(0xFFFFFF), .bordered = false};
constexpr Palette light = {
    .canvas = rgb(0xD0D0D0), .panel = rgb(0xF4F4F4), .field = rgb(0xFFFFFF), .hover = rgb(0xE3EDF5),
    .text = rgb(0x1B1B1B), .label = rgb(0x484848), .dim = rgb(0x636363),
    .driven = rgb(0x00619A), .done = rgb(0x1E6B3A), .warning = rgb(0x7A6200), .error = rgb(0xA3151F),
    .border = rgb(0x808080), .selection = rgb(0xCBE3F4), .focus = rgb(0x000000), .bordered = true};
constexpr Palette high_contrast = {
    .canvas = rgb(0x000000), .panel = rgb(0x000000), .field = rgb(0x000000), .hover = rgb(0x303030),
    .text = rgb(0xFFFFFF), .label = rgb(0xFFFFFF), .dim = rgb(0xD0D0D0),
    .driven = rgb(0x56B4E9), .done = rgb(0x8FD9A8), .warning = rgb(0xF2D35B), .error = rgb(0xFF7355),
    .border = rgb(0xFFFFFF), .selection = rgb(0x2B4A63), .focus = rgb(0xFFFFFF), .bordered = true};

float luminance(ImU32 color) {
  const auto linear = [&](int shift) {
    const float c = static_cast<float>(color >> shift & 255) / 255;
    return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
  };
  return 0.2126f * linear(IM_COL32_R_SHIFT) + 0.7152f * linear(IM_COL32_G_SHIFT) + 0.0722f * linear(IM_COL32_B_SHIFT);
}

}  // namespace

const Palette& palette(Theme theme) {
  switch (theme) {
    case Theme::light: return light;
    case Theme::high_contrast: return high_contrast;
    case Theme::dark: break;
  }
  return dark;
}

float contrast(ImU32 one, ImU32 other) {
  const auto [low, high] = std::minmax({luminance(one), luminance(other)});
  return (high + 0.05f) / (low + 0.05f);
}

ImU32 faded(ImU32 color, float factor) {
  const auto alpha = static_cast<float>(color >> IM_COL32_A_SHIFT & 255) * std::clamp(factor, 0.0f, 1.0f);
  return (color & ~IM_COL32_A_MASK) | static_cast<ImU32>(alpha + 0.5f) << IM_COL32_A_SHIFT;
}

}  // namespace lumen::ui
