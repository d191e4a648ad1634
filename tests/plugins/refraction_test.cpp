/// compositor.refraction: what is behind glass is moved as Snell's law says, and nothing else is.
#include <cmath>

#include <gtest/gtest.h>
#include <lumen/testing.h>

namespace {

using lumen::testing::Pixels;
using lumen::testing::Scene;

/// A wall, red on the left of x = 0 and green on the right, behind a nearly clear pane turned by 45 degrees about y: its normal
/// leans toward +x. The scene's bounds are 6 x 4 x (2 + sqrt 2).
struct Glass {
  Scene scene{{128, 128}};
  const float radius = 0.5f * std::sqrt(36 + 16 + (2 + std::sqrt(2.0f)) * (2 + std::sqrt(2.0f)));

  Glass() {
    scene.add("opacity.constant", "faint", R"({"alpha": 0.01})");
    scene.add("transparency.weighted", "weighted");
    const auto half = lumen::testing::rectangle(3, 4);
    scene.surface("left", lumen::testing::moved(*half, {-1.5f, 0, -2}), R"({"ambient_color": [1, 0, 0]})");
    scene.surface("right", lumen::testing::moved(*half, {1.5f, 0, -2}), R"({"ambient_color": [0, 1, 0]})");
    scene.surface("pane", lumen::testing::rectangle(4, 4),
                  R"({"opacity": "faint", "transform": [0.70710678,0,0.70710678,0, 0,1,0,0, -0.70710678,0,0.70710678,0, 0,0,0,1]})");
    scene.add("compositor.refraction", "refraction", R"({"index": 1.5, "thickness": 0.25})");
  }
  /// Where red turns to green in the middle row, world.
  float border() {
    const Pixels picture = scene.picture();
    int x = 0;
    while (x < 127 && picture.rgb(x, 64).g < picture.rgb(x, 64).r) ++x;
    return (float(x) - 64) * 2.2f / 128;
  }
};

TEST(Refraction, MovesWhatIsBehindBySnellsLaw) {
  Glass glass;
  const float pi = 3.14159265f, inside = std::asin(std::sin(pi / 4) / 1.5f);
  EXPECT_NEAR(glass.border(), 0.25f * glass.radius * std::tan(pi / 4 - inside), 1.5f * 2.2f / 128);
  glass.scene.set("refraction.thickness", "0.1");
  EXPECT_NEAR(glass.border(), 0.1f * glass.radius * std::tan(pi / 4 - inside), 1.5f * 2.2f / 128);
}

TEST(Refraction, OfIndexOneLeavesThePictureAsItIsAndAnOcclusionChangesNothing) {
  Glass glass;
  glass.scene.set("refraction.index", "1");
  EXPECT_NEAR(glass.border(), 0, 1.0f * 2.2f / 128);
  glass.scene.set("refraction.index", "1.5");
  const float bent = glass.border();
  glass.scene.add("occlusion.ssao", "ssao", R"({"radius": 0.001})");  // its layers are the same front layer
  EXPECT_NEAR(glass.border(), bent, 1e-6f);
  EXPECT_TRUE(glass.scene.problems().empty());
}

TEST(Refraction, LeavesAViewWithoutTransparentSurfacesAlone) {
  Scene scene({32, 32});
  scene.surface("ball", lumen::testing::sphere(), R"({"ambient_color": [0.5, 0.25, 1]})");
  scene.add("compositor.refraction", "refraction");
  EXPECT_EQ(scene.picture().rgb(16, 16), glm::vec3(0.5f, 0.25f, 1));
  EXPECT_TRUE(scene.problems().empty());
}

}  // namespace
