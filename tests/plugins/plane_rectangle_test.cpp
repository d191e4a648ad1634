// renderer.plane: where the rectangle lies, how it is lit, what it fits.
#include <cmath>

#include <gtest/gtest.h>
#include <lumen/testing.h>

namespace {

using lumen::testing::Pixels;
using lumen::testing::Scene;

/// 100 pixels per world unit; the plane z = 0 is 10 away.
struct PlaneRectangle : testing::Test {
  PlaneRectangle() {
    scene.set("camera.height", "2");
    scene.add("ambient.constant", "ambient");
    scene.add("diffuse.lambert", "diffuse");
    scene.add("renderer.plane", "plane", R"({"scale": [0.5, 0.25], "translation": [0.2, -0.1, 0], "ambient": "ambient", "diffuse": "diffuse",
      "ambient_color": [0, 0, 0], "diffuse_color": [0.5, 0.25, 1], "frame_width": 0})");
  }
  static int covered(const Pixels& depth) {
    int count = 0;
    for (int y = 0; y < depth.height(); ++y)
      for (int x = 0; x < depth.width(); ++x) count += !std::isinf(depth.at(x, y));
    return count;
  }
  template <class T> T value(const std::string& path) const { return std::get<T>(scene.value(path)); }

  Scene scene{{200, 200}};
};

TEST_F(PlaneRectangle, HasTwiceItsScaleAsSidesAboutItsTranslation) {
  const Pixels depth = scene.layer("depth");
  EXPECT_EQ(covered(depth), 100 * 50);
  for (const auto& [x, y] : {std::pair(70, 85), std::pair(169, 134)}) EXPECT_NEAR(depth.at(x, y), 10, 1e-5f);
  for (const auto& [x, y] : {std::pair(69, 85), std::pair(70, 84), std::pair(170, 134), std::pair(169, 135)}) EXPECT_TRUE(std::isinf(depth.at(x, y)));
  EXPECT_TRUE(scene.problems().empty());
}

TEST_F(PlaneRectangle, IsSeenByTheCosineOfItsAngleAndLeansAsTheSplittersPlane) {
  scene.set("plane.axis", "[0, 0.5, 0]");  // any length
  scene.set("plane.angle", "60");
  const Pixels depth = scene.layer("depth");
  EXPECT_NEAR(covered(depth), 100 * 50 * 0.5, 50);
  // The normal is (sin 60, 0, cos 60): what lies to the right of the middle is farther.
  for (const int x : {100, 120, 140}) EXPECT_NEAR(depth.at(x, 110), 10 + (float(x) + 0.5f - 120) / 100 * std::tan(glm::radians(60.0f)), 1e-3f) << x;
}

TEST_F(PlaneRectangle, IsLitOnBothSides) {
  for (const char* angle : {"0", "180", "-180"}) {
    scene.set("plane.angle", angle);
    const glm::vec3 lit = scene.layer("diffuse").rgb(120, 110);
    EXPECT_NEAR(glm::distance(lit, glm::vec3(0.5f, 0.25f, 1)), 0, 1e-3f) << angle << ": the light falls straight on it";
  }
  scene.set("plane.angle", "240");  // no more than 180
  EXPECT_NEAR(scene.layer("diffuse").rgb(120, 110).b, 1, 1e-3f);
  scene.set("plane.angle", "120");
  EXPECT_NEAR(scene.layer("diffuse").rgb(120, 110).b, 0.5f, 1e-3f);
}

TEST_F(PlaneRectangle, TakesItsOpacityFromATerm) {
  scene.add("opacity.constant", "faint", R"({"alpha": 0.3})");
  scene.add("transparency.linked_list", "sorted");
  scene.set("plane.opacity", "faint");
  const Pixels opacity = scene.layer("opacity"), color = scene.layer("transparent");
  EXPECT_NEAR(opacity.at(120, 110), 0.3f, 1e-3f);
  EXPECT_EQ(opacity.at(60, 110), 0);
  EXPECT_NEAR(glm::distance(color.rgb(120, 110), 0.3f * glm::vec3(0.5f, 0.25f, 1)), 0, 2e-3f);
}

TEST_F(PlaneRectangle, HasAFrameOfItsOwnColor) {
  scene.set("plane.frame_width", "3");
  scene.set("plane.frame_color", "[0, 1, 0]");
  const Pixels diffuse = scene.layer("diffuse");
  const auto framed = [&](int x, int y) { return diffuse.rgb(x, y).g > 0.9f && diffuse.rgb(x, y).b < 0.1f; };
  for (const int in : {0, 1, 2}) EXPECT_TRUE(framed(70 + in, 110) && framed(169 - in, 110) && framed(120, 85 + in) && framed(120, 134 - in)) << in;
  EXPECT_FALSE(framed(73, 110) || framed(166, 110) || framed(120, 88) || framed(120, 131));
}

TEST_F(PlaneRectangle, FitsAMeshUntilItIsSet) {
  scene.give("box", lumen::testing::moved(*lumen::testing::box({2, 1, 0.5f}), {3, 4, 5}));
  scene.add("renderer.plane", "fitted", R"({"mesh": {"link": "box.mesh"}})");
  scene.picture();
  EXPECT_EQ(value<glm::vec3>("fitted.translation"), glm::vec3(3, 4, 5));
  EXPECT_NEAR(glm::distance(value<glm::vec2>("fitted.scale"), 1.1f * glm::vec2(1, 0.5f)), 0, 1e-5f);
  scene.set("fitted.angle", "90");  // about y: its sides are those along z and y
  scene.picture();
  EXPECT_NEAR(glm::distance(value<glm::vec2>("fitted.scale"), 1.1f * glm::vec2(0.25f, 0.5f)), 0, 1e-5f);
  scene.set("fitted.scale", "[7, 7]");
  scene.set("fitted.angle", "0");
  scene.picture();
  EXPECT_EQ(value<glm::vec2>("fitted.scale"), glm::vec2(7));
}

TEST_F(PlaneRectangle, CastsNoShadowOfRays) {
  scene.surface("floor", lumen::testing::moved(*lumen::testing::rectangle(4, 4), {0, 0, -0.1f}), R"({"ambient": "ambient"})");
  scene.add("occlusion.traced", "rays");
  scene.set("plane.enabled", "false");
  const Pixels without = scene.layer("occlusion");
  scene.set("plane.enabled", "true");
  const Pixels with = scene.layer("occlusion");
  EXPECT_NEAR(with.at(20, 20), without.at(20, 20), 1e-3f);
  EXPECT_NEAR(with.at(60, 110), without.at(60, 110), 1e-3f) << "beside the rectangle";
}

}  // namespace
