/// splitter.volume: each shape cuts what it must, to the pixel and in depth, and nothing else.

#include <cmath>

#include <gtest/gtest.h>
#include <lumen/testing.h>

namespace {

using lumen::testing::Pixels;
using lumen::testing::Scene;

constexpr int side = 220;  // 100 pixels per world unit
constexpr float pi = 3.14159265f;

/// A plate of 2 x 2 at z = 0 that faces the eye, cut by the volume.
void add_plate(Scene& scene, const char* volume) {
  scene.add("diffuse.lambert", "lambert");
  scene.add("splitter.volume", "volume", volume);
  scene.surface("plate", lumen::testing::rectangle(), R"({"diffuse": "lambert", "splitter": "volume"})");
}

/// World units that are missing of the plate.
float missing(Scene& scene) {
  const Pixels depth = scene.layer("depth");
  int covered = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) covered += !std::isinf(depth.at(x, y));
  return 4 - float(covered) * 1e-4f;
}

bool is_there(const Pixels& depth, float x, float y) { return !std::isinf(depth.at(int(110 + 100 * x), int(110 - 100 * y))); }

TEST(VolumeCut, ASphereCutsACircle) {
  Scene scene({side, side});
  add_plate(scene, R"({"shape": "sphere", "center": [0.1, 0.2, 0.3], "radius": 0.5})");
  EXPECT_NEAR(missing(scene), pi * 0.16f, 0.01f) << "0.3 off its center it is 0.4 wide";
  const Pixels depth = scene.layer("depth");
  EXPECT_FALSE(is_there(depth, 0.1f, 0.2f));
  EXPECT_FALSE(is_there(depth, 0.1f + 0.38f, 0.2f));
  EXPECT_TRUE(is_there(depth, 0.1f + 0.42f, 0.2f));
}

TEST(VolumeCut, ATurnedBoxCutsASquareOnItsCorner) {
  Scene scene({side, side});
  // Turned by 45 degrees about z.
  add_plate(scene, R"({"shape": "box", "center": [0, 0, 0], "size": [1, 0.5, 0.2], "rotation": [0, 0, 0.38268343, 0.92387953]})");
  EXPECT_NEAR(missing(scene), 0.5f, 0.01f);
  const Pixels depth = scene.layer("depth");
  EXPECT_FALSE(is_there(depth, 0.33f, 0.33f));
  EXPECT_TRUE(is_there(depth, 0.37f, 0.37f));
  EXPECT_FALSE(is_there(depth, -0.16f, 0.16f));
  EXPECT_TRUE(is_there(depth, -0.19f, 0.19f));
}

TEST(VolumeCut, AWedgeCutsASectorAboutItsXAxis) {
  for (const float angle : {60.0f, 180.0f}) {
    Scene scene({side, side});
    add_plate(scene, R"({"shape": "wedge", "center": [0, 0, 0], "radius": 0.8, "length": 1})");
    scene.set("volume.angle", std::to_string(angle));
    EXPECT_NEAR(missing(scene), 0.64f * pi * angle / 360, 0.01f);
    const Pixels depth = scene.layer("depth");
    EXPECT_FALSE(is_there(depth, 0.7f, 0));
    EXPECT_TRUE(is_there(depth, -0.1f, 0));
  }
}

TEST(VolumeCut, ATubeCutsACircleAndAcrossARectangle) {
  Scene scene({side, side});
  add_plate(scene, R"({"shape": "tube", "center": [0, 0, 0], "radius": 0.3, "length": 1.2})");
  EXPECT_NEAR(missing(scene), pi * 0.09f, 0.01f);
  scene.set("volume.rotation", "[0.70710678, 0, 0, 0.70710678]");
  EXPECT_NEAR(missing(scene), 0.6f * 1.2f, 0.01f);
  scene.set("volume.center", "[0, 0, 0.31]");
  EXPECT_NEAR(missing(scene), 0, 0.01f) << "it passes before the plate";
}

TEST(VolumeCut, TheRestAndWhatIsCutAreTheWholeSurface) {
  Scene scene({side, side});
  add_plate(scene, R"({"center": [0, 0, 0], "radius": 0.6, "size": [0.7, 0.9, 0.5], "length": 0.8, "rotation": [0.2, 0.3, 0.1, 0.93]})");
  for (const char* shape : {"sphere", "box", "wedge", "tube"}) {
    scene.set("volume.shape", shape);
    scene.set("volume.keep", "rest");
    const float rest = missing(scene);
    EXPECT_GT(rest, 0.05f) << shape;
    scene.set("volume.keep", "removed");
    EXPECT_NEAR(missing(scene), 4 - rest, 1e-4f) << shape;
  }
}

TEST(VolumeCut, WhatIsOutsideIsUntouched) {
  Scene scene({side, side});
  add_plate(scene, R"({"center": [0, 0, 0], "radius": 0.5})");
  const Pixels cut = scene.layer("color");
  scene.set("plate.splitter", "[]");
  const Pixels whole = scene.layer("color");
  int wrong = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      if (std::hypot(float(x) - 109.5f, float(y) - 109.5f) > 50.5f) wrong += cut.rgba(x, y) != whole.rgba(x, y);
  EXPECT_EQ(wrong, 0);
}

TEST(VolumeCut, TheCutIsLitAsItsWall) {
  const struct { const char* volume; glm::vec3 normal; } cases[] = {
      // The eye's ray at x = 0.3 leaves the solid ball through the volume's wall: (0.3, 0, z) from its center, inward.
      {R"({"shape": "sphere", "center": [0, 0, 1], "radius": 0.5})", {-0.6f, 0, 0.8f}},
      {R"({"shape": "tube", "center": [0, 0, 1], "radius": 0.5, "length": 3, "rotation": [0.70710678, 0, 0, 0.70710678]})", {-0.6f, 0, 0.8f}},
      {R"({"shape": "box", "center": [0, 0, 1], "size": [1, 1, 1]})", {0, 0, 1}},
      // Its edge along y, opening toward the eye: the side that rises to the right at 45 degrees.
      {R"({"shape": "wedge", "center": [0, 0, 0], "radius": 2, "length": 3, "rotation": [-0.5, -0.5, -0.5, 0.5]})", {-0.70710678f, 0, 0.70710678f}}};
  for (const auto& [volume, expected] : cases) {
    Scene scene({side, side});
    scene.add("diffuse.lambert", "lambert");
    scene.add("splitter.volume", "volume", volume);
    scene.surface("ball", lumen::testing::sphere(128), R"({"diffuse": "lambert", "splitter": "volume"})");
    const Pixels normal = scene.layer("normal"), depth = scene.layer("depth");
    EXPECT_GT(depth.at(110 + 30, 110), 10.9f) << "the far side of the ball is seen";
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(normal.at(110 + 30, 110, i), expected[i], 0.02f) << volume << ", component " << i;
  }
}

TEST(VolumeCut, WholePartsStay) {
  Scene scene({side, side});
  scene.add("diffuse.lambert", "lambert");
  scene.add("splitter.volume", "volume", R"({"center": [0, 0, 0], "radius": 0.5, "whole": [1]})");
  const std::vector<std::shared_ptr<lumen::Mesh>> both = {lumen::testing::rectangle(), lumen::testing::moved(*lumen::testing::sphere(64, 0.2f), {0.1f, 0, 0})};
  scene.surface("both", lumen::testing::joined(both), R"({"diffuse": "lambert", "splitter": "volume"})");
  EXPECT_NEAR(missing(scene), pi * (0.25f - 0.04f), 0.01f);
}

TEST(VolumeCut, FitsAnySceneUntilItIsSet) {
  Scene scene({side, side});
  scene.set("camera.height", "220");
  scene.add("diffuse.lambert", "lambert");
  scene.add("splitter.volume", "volume");
  scene.surface("ball", lumen::testing::sphere(64, 80), R"({"diffuse": "lambert", "splitter": "volume"})");
  const Pixels first = scene.layer("depth");
  EXPECT_EQ(lumen::testing::largest_difference(first, scene.layer("depth")), 0) << "the first picture has it";
  EXPECT_EQ(scene.runs("geometry"), 1);
  const float radius = std::get<float>(scene.value("volume.radius"));
  EXPECT_GT(radius, 20);
  EXPECT_LT(radius, 100);
  EXPECT_NEAR(glm::distance(std::get<glm::vec3>(scene.value("volume.center")), glm::vec3(0, -80, 0)), 0, 1e-3f);
  EXPECT_TRUE(std::isinf(first.at(side / 2, side / 2 + 75))) << "a bite out of the ball";
  EXPECT_FALSE(std::isinf(first.at(side / 2, side / 2)));
  scene.set("volume.radius", "3");
  scene.layer("depth");
  EXPECT_EQ(std::get<float>(scene.value("volume.radius")), 3);
}

}  // namespace
