/// The sphere that shows a light while it is turned.
#include <array>

#include <gtest/gtest.h>
#include <lumen/testing.h>

namespace {

using lumen::testing::Pixels;
using lumen::testing::Scene;

/// A gray wall behind the sphere; the light shines from the eye's right.
struct LightSphere : testing::Test {
  LightSphere() {
    scene.add("ambient.constant", "ambient");
    scene.surface("wall", lumen::testing::rectangle(4, 4), R"({"ambient": "ambient", "ambient_color": [0.25, 0.25, 0.25]})");
    scene.set("main.interactors", R"(["front"])");
    scene.set("front.direction", "[3, 0, 4]");
  }
  static constexpr int size = 100;
  static constexpr float radius = 45;
  /// Straight to the right of the middle, in pixels.
  float right(const Pixels& picture, float distance) const { return picture.rgb(int(size / 2 + distance), size / 2).g; }

  Scene scene{{size, size}};
};

TEST_F(LightSphere, IsThereOnlyWhileItIsAskedForAndLeavesThePictureAsItWas) {
  const Pixels before = scene.picture();
  EXPECT_EQ(scene.runs("front"), 0);
  scene.set("front.sphere", "true");
  EXPECT_GT(lumen::testing::largest_difference(before, scene.picture()), 0.5f);
  EXPECT_EQ(scene.runs("front"), 1);
  scene.set("front.sphere", "false");
  EXPECT_EQ(lumen::testing::largest_difference(before, scene.picture()), 0);
  scene.set("camera.rotation", "[0, 0, 0.6, 0.8]");
  scene.picture();
  EXPECT_EQ(scene.runs("front"), 1) << "an unseen sphere is not drawn";
  EXPECT_EQ(scene.runs("lighting"), 2) << "the sphere lies over the picture: it lights nothing anew";
  EXPECT_TRUE(scene.problems().empty());
}

TEST_F(LightSphere, HasItsDotWhereTheLightShinesFrom) {
  scene.set("front.sphere", "true");
  const Pixels lit = scene.picture();
  EXPECT_NEAR(right(lit, 0.6f * radius), 1, 0.01f) << "3 of 5 to the right";
  EXPECT_NEAR(right(lit, 0.6f * radius - 12), 0.25f, 0.01f) << "beside it the wall";
  scene.set("front.direction", "[3, 0, -4]");
  const Pixels behind = scene.picture();
  EXPECT_NEAR(right(behind, 0.6f * radius + 6), 1, 0.3f) << "a ring";
  EXPECT_LT(right(behind, 0.6f * radius + 2), 0.3f) << "that is hollow";
}

TEST_F(LightSphere, HasTheTerminatorAtRightAnglesToTheLight) {
  scene.set("front.sphere", "true");
  const Pixels picture = scene.picture();
  // (-0.8, 0, 0.6) is at right angles to (0.6, 0, 0.8).
  EXPECT_GT(right(picture, -0.8f * radius), 0.6f);
  // Outside of the sphere nothing is drawn.
  EXPECT_NEAR(right(picture, radius + 3), 0.25f, 0.01f);
}

TEST_F(LightSphere, ShowsAPointFromWhatItTurnsAbout) {
  scene.set("front.kind", "point");
  scene.set("camera.pivot", "[0.5, 0, 0]");
  scene.set("front.position", "[1.1, 0, 0.8]");
  scene.set("front.sphere", "true");
  EXPECT_NEAR(right(scene.picture(), 0.6f * radius), 1, 0.01f);
}

}  // namespace
