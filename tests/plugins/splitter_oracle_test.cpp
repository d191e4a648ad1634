/// splitter.plane: the halves lie where they must, and nothing is lost between them.

#include <cmath>

#include <gtest/gtest.h>
#include <lumen/testing.h>

namespace {

using lumen::testing::Pixels;
using lumen::testing::Scene;

constexpr const char* ball = R"({"ambient": "ambient", "diffuse": "diffuse", "splitter": "cut"})";

/// The plane x = 0, seen from +z.
void add_split_ball(Scene& scene, float offset) {
  scene.add("ambient.constant", "ambient");
  scene.add("diffuse.lambert", "diffuse");
  scene.add("splitter.plane", "cut", R"({"axis": [0, 1, 0], "angle": 90})");
  scene.set("cut.offset", std::to_string(offset));
  scene.surface("ball", lumen::testing::sphere(128), ball);
}

TEST(PlaneSplitter, OffsetZeroIsTheUnsplitPicture) {
  for (const char* offset : {"0", "0.000001"}) {
    Scene split({200, 200}), whole({200, 200});
    add_split_ball(split, 0);
    split.set("cut.offset", offset);
    add_split_ball(whole, 0);
    whole.set("ball.splitter", "\"\"");
    const Pixels a = split.layer("color"), b = whole.layer("color");
    int covered = 0, different = 0;
    for (int y = 0; y < 200; ++y) {
      for (int x = 0; x < 200; ++x) {
        if (b.rgba(x, y).a == 0) continue;
        ++covered;
        EXPECT_EQ(a.rgba(x, y).a, 1) << "a hole at " << x << ", " << y;
        const glm::vec3 d = glm::abs(a.rgb(x, y) - b.rgb(x, y));
        different += std::max({d.x, d.y, d.z}) > 1.0f / 255;
      }
    }
    EXPECT_LE(different, covered * 1e-4) << "offset " << offset;
  }
}

TEST(PlaneSplitter, GapIsTwiceTheOffsetWide) {
  Scene scene({400, 100});
  scene.set("camera.height", "1");  // 100 pixels per world unit
  const float offset = 0.3f;
  add_split_ball(scene, offset);
  const Pixels depth = scene.layer("depth");
  int left = 200, right = 199;
  while (std::isinf(depth.at(left - 1, 50))) --left;
  while (std::isinf(depth.at(right + 1, 50))) ++right;
  EXPECT_NEAR((right - left + 1) / 2.0f, offset * 100, 1);
  EXPECT_NEAR(200 - left, offset * 100, 1);
}

TEST(PlaneSplitter, HalfASphereCoversHalfADisk) {
  Scene scene({220, 220});  // 100 pixels per world unit
  add_split_ball(scene, 4);  // the other half is out of sight
  scene.set("camera.pivot", "[4, 0, 0]");
  const Pixels depth = scene.layer("depth");
  int covered = 0;
  for (int y = 0; y < 220; ++y)
    for (int x = 0; x < 220; ++x) covered += !std::isinf(depth.at(x, y));
  EXPECT_NEAR(covered / 1e4, 3.14159265 / 2, 0.01);
}

TEST(PlaneSplitter, CutsInWorldSpaceUnderNonUniformScale) {
  Scene scene({220, 220});
  add_split_ball(scene, 0.2f);
  scene.set("ball.transform", "[0.5,0,0,0, 0,1,0,0, 0,0,2,0, 0,0,0,1]");
  const Pixels depth = scene.layer("depth");
  EXPECT_TRUE(std::isinf(depth.at(110 - 18, 110)));
  EXPECT_FALSE(std::isinf(depth.at(110 - 22, 110)));
  EXPECT_FALSE(std::isinf(depth.at(110 + 68, 110)));
  EXPECT_TRUE(std::isinf(depth.at(110 + 72, 110)));
}

TEST(PlaneSplitter, HonoredByTransparentSurfaces) {
  Scene scene({200, 200});
  add_split_ball(scene, 0.2f);
  scene.add("opacity.constant", "alpha", R"({"alpha": 0.5})");
  scene.add("transparency.weighted", "weighted");
  scene.set("ball.opacity", "alpha");
  const Pixels opacity = scene.layer("opacity");
  EXPECT_EQ(opacity.at(100, 100), 0);
  EXPECT_NEAR(opacity.at(160, 100), 0.75f, 1e-4f);
}

}  // namespace
