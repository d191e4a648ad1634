// The token table's contrasts, and colors as people write them.
#include <gtest/gtest.h>

#include <lumen/ui/color.h>
#include <lumen/ui/color_maps.h>
#include <lumen/ui/palette.h>

namespace {

using namespace lumen::ui;

TEST(Palette, KeepsItsContrastsOnPanelsAndFields) {
  const Palette& dark = palette(Theme::dark);
  EXPECT_NEAR(contrast(dark.text, dark.panel), 13.1, 0.1);
  EXPECT_NEAR(contrast(dark.text, dark.field), 10.5, 0.1);
  EXPECT_NEAR(contrast(dark.driven, dark.panel), 6.7, 0.1);
  EXPECT_NEAR(contrast(dark.error, dark.field), 4.6, 0.1);
  const Palette& light = palette(Theme::light);
  EXPECT_NEAR(contrast(light.text, light.field), 17.2, 0.1);
  EXPECT_NEAR(contrast(light.warning, light.panel), 5.3, 0.1);
}

TEST(Palette, IsReadableInEveryTheme) {
  for (const Theme theme : {Theme::dark, Theme::light, Theme::high_contrast}) {
    const Palette& colors = palette(theme);
    for (const ImU32 color : {colors.text, colors.label, colors.dim, colors.driven, colors.done, colors.warning, colors.error}) {
      EXPECT_GE(contrast(color, colors.panel), 4.5f);
      EXPECT_GE(contrast(color, colors.field), 4.5f);
    }
    EXPECT_GE(contrast(colors.text, colors.selection), 4.5f);
  }
}

TEST(Colors, AreWrittenAsSrgbAndKeptLinear) {
  EXPECT_EQ(hex_of({0.715694f, 0.039546f, 0.049707f}), "DC383F");
  const glm::vec3 linear = color_of("#DC3840").value();
  EXPECT_NEAR(linear.r, 0.715694f, 1e-3f);
  EXPECT_NEAR(color_of("fff")->g, 1, 1e-6f);
  for (const char* text : {"", "12345", "GG0000", "#1234567"}) EXPECT_FALSE(color_of(text)) << text;
}

TEST(Colors, SurviveTheWayToSrgbAndBack) {
  for (const float value : {0.0f, 0.001f, 0.2f, 0.5f, 1.0f}) EXPECT_NEAR(from_srgb(to_srgb(glm::vec3(value))).x, value, 1e-5f);
}

TEST(ColorMaps, ChangeColorsAndKeepOpacity) {
  lumen::TransferFunction function{{0, 10}, {{0, {1, 1, 1, 0}}, {10, {1, 1, 1, 1}}}};
  const auto mapped = with_colors(function, "viridis");
  EXPECT_EQ(mapped.range, function.range);
  EXPECT_NEAR(mapped.at(5).a, 0.5f, 1e-5f);
  EXPECT_EQ(hex_of(glm::vec3(mapped.at(0))), "440154");
  EXPECT_EQ(hex_of(glm::vec3(mapped.at(10))), "FDE725");
  EXPECT_EQ(with_colors(function, "no such map"), function);
}

}  // namespace
