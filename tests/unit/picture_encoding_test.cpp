/// Layers become what files hold.
#include <cmath>

#include <gtest/gtest.h>

#include "command/frame_name.h"
#include "command/picture_encoding.h"
#include "command/samples.h"

namespace lumenshop {
namespace {

std::shared_ptr<lumen::Image> image(int width, int height, std::vector<std::string> channels, std::vector<float> pixels) {
  auto result = std::make_shared<lumen::Image>();
  result->width = width;
  result->height = height;
  result->channels = std::move(channels);
  result->pixels = std::move(pixels);
  result->finish();
  return result;
}

TEST(SrgbEncoding, FollowsTheStandard) {
  EXPECT_FLOAT_EQ(srgb_encoded(0), 0);
  EXPECT_FLOAT_EQ(srgb_encoded(1), 1);
  EXPECT_NEAR(srgb_encoded(0.5f), 0.735357f, 1e-5);
  EXPECT_NEAR(srgb_encoded(0.002f), 0.02584f, 1e-6);
  EXPECT_FLOAT_EQ(srgb_encoded(-3), 0);
  EXPECT_FLOAT_EQ(srgb_encoded(7), 1);
  EXPECT_FLOAT_EQ(srgb_encoded(NAN), 0);
}

TEST(DisplayableColor, IsEncodedAndLosesAnOpaqueAlpha) {
  const auto shown = displayable(*image(1, 1, {"R", "G", "B", "A"}, {0.5f, 0, 2, 1}), "color", {});
  ASSERT_EQ(shown->channels, (std::vector<std::string>{"R", "G", "B"}));
  EXPECT_NEAR(shown->pixels[0], 0.735357f, 1e-4);
  EXPECT_FLOAT_EQ(shown->pixels[1], 0);
  EXPECT_FLOAT_EQ(shown->pixels[2], 1);
}

TEST(DisplayableColor, IsStraightWhereItIsTranslucent) {
  const auto shown = displayable(*image(2, 1, {"R", "G", "B", "A"}, {0.25f, 0, 0, 0.5f, 0, 0, 0, 0}), "color", {});
  ASSERT_EQ(shown->channels.size(), 4u);
  EXPECT_NEAR(shown->pixels[0], 0.735357f, 1e-4);  // 0.25 / 0.5, encoded
  EXPECT_FLOAT_EQ(shown->pixels[3], 0.5f);
  EXPECT_FLOAT_EQ(shown->pixels[7], 0);
}

TEST(DisplayableColor, StaysLinearWhenAsked) {
  EXPECT_FLOAT_EQ(displayable(*image(1, 1, {"R", "G", "B"}, {0.5f, 0.5f, 0.5f}), "diffuse", {.encode_srgb = false})->pixels[0], 0.5f);
}

TEST(DisplayableLayers, NormalsAreHalvedAndDepthsLieInTheExtent) {
  const auto normal = displayable(*image(1, 1, {"X", "Y", "Z"}, {-1, 0, 1}), "normal", {});
  EXPECT_FLOAT_EQ(normal->pixels[0], 0);
  EXPECT_FLOAT_EQ(normal->pixels[1], 0.5f);
  EXPECT_FLOAT_EQ(normal->pixels[2], 1);
  const auto depth = displayable(*image(3, 1, {"Z"}, {3, 2, INFINITY}), "depth", {.extent = {2, 4}});
  EXPECT_FLOAT_EQ(depth->pixels[0], 0.5f);
  EXPECT_FLOAT_EQ(depth->pixels[1], 0);
  EXPECT_FLOAT_EQ(depth->pixels[2], 1);
  const auto id = displayable(*image(1, 1, {"R", "G", "B"}, {2, 1, 300}), "id", {});
  EXPECT_FLOAT_EQ(id->pixels[0] * 255, 2);
  EXPECT_FLOAT_EQ(id->pixels[2] * 255, 44);
}

TEST(CombinedLayers, KeepTheirNamesAndValues) {
  const auto all = combined({{"diffuse", image(2, 1, {"R", "G", "B"}, {1, 2, 3, 4, 5, 6})}, {"depth", image(2, 1, {"Z"}, {7, INFINITY})},
                             {"normal", image(2, 1, {"X", "Y", "Z"}, {0, 0, 1, 0, 1, 0})}});
  EXPECT_EQ(all->channels, (std::vector<std::string>{"diffuse.R", "diffuse.G", "diffuse.B", "depth.Z", "normal.X", "normal.Y", "normal.Z"}));
  EXPECT_FLOAT_EQ(all->pixels[3], 7);
  EXPECT_FLOAT_EQ(all->pixels[7], 4);
  EXPECT_FLOAT_EQ(all->pixels[12], 1);
  EXPECT_THROW(combined({{"depth", image(1, 1, {"R"}, {0})}, {"opacity", image(2, 1, {"R"}, {0, 0})}}), std::exception);
}

TEST(SceneExtent, IsThatOfTheBoundingSphereAlongTheAxis) {
  lumen::Camera camera;
  camera.view[3] = glm::vec4(0, 0, -10, 1);
  lumen::Bounds bounds;
  bounds.include(glm::vec3(-1));
  bounds.include(glm::vec3(1));
  const glm::vec2 extent = scene_extent(camera, bounds);
  EXPECT_NEAR(extent.x, 10 - std::sqrt(3.0f), 1e-5);
  EXPECT_NEAR(extent.y, 10 + std::sqrt(3.0f), 1e-5);
  camera.view = glm::mat4(1);  // the eye is in the middle
  EXPECT_GT(scene_extent(camera, bounds).x, 0);
}

TEST(FrameName, PutsTheNumberWhereItIsWanted) {
  EXPECT_EQ(frame_name("out/a.png", 7), "out/a_0007.png");
  EXPECT_EQ(frame_name("a.###.png", 7), "a.007.png");
  EXPECT_EQ(frame_name("a#.png", 1234), "a1234.png");
  EXPECT_EQ(frame_name("a%04d.exr", 12), "a0012.exr");
  EXPECT_EQ(frame_name("a%d.exr", 12), "a12.exr");
  EXPECT_EQ(frame_name("100%.png", 3), "100%_0003.png");
}

TEST(Quartiles, AreInterpolated) {
  const Quartiles quartiles = quartiles_of({4, 1, 3, 2});
  EXPECT_DOUBLE_EQ(quartiles.median, 2.5);
  EXPECT_DOUBLE_EQ(quartiles.first, 1.75);
  EXPECT_DOUBLE_EQ(quartiles.spread(), 1.5);
  EXPECT_DOUBLE_EQ(quartiles_of({}).median, 0);
}

}  // namespace
}  // namespace lumenshop
