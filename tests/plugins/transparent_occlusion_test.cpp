/// Occlusion on transparent surfaces: each of the front-most layers has its own, the same as if it were opaque.
#include <gtest/gtest.h>
#include <lumen/testing.h>

namespace {

using lumen::testing::Pixels;
using lumen::testing::Scene;

/// Two white rectangles that meet at a right angle along x = 0, in ambient light alone.
void add_crease(Scene& scene, const std::string& opacity) {
  const std::string style = R"({"ambient": "ambient", "ambient_color": [1, 1, 1], "opacity": ")" + opacity + R"(", "transform": )";
  scene.surface("left", lumen::testing::rectangle(4, 4), style + "[0.7071068,0,0.7071068,-1.4142, 0,1,0,0, -0.7071068,0,0.7071068,1.4142, 0,0,0,1]}");
  scene.surface("right", lumen::testing::rectangle(4, 4), style + "[0.7071068,0,-0.7071068,1.4142, 0,1,0,0, 0.7071068,0,0.7071068,1.4142, 0,0,0,1]}");
  scene.add("ambient.constant", "ambient");
  scene.add("occlusion.ssao", "ssao", R"({"radius": 0.1})");
  scene.add("transparency.weighted", "weighted");
}

TEST(TransparentOcclusion, IsThatOfTheSameSurfaceWhenOpaque) {
  Scene opaque({96, 96}), transparent({96, 96});
  add_crease(opaque, "");
  transparent.add("opacity.constant", "solid", R"({"alpha": 1})");
  add_crease(transparent, "solid");
  ASSERT_GT(opaque.layer("occlusion").at(49, 48), 0.1f);
  EXPECT_LT(lumen::testing::largest_difference(opaque.layer("color"), transparent.layer("color")), 1e-4f);
  transparent.set("main.occluded_layers", "0");
  EXPECT_NEAR(transparent.layer("color").at(49, 48), 1.0f, 1e-4f) << "switched off";
}

TEST(TransparentOcclusion, LayersBehindOthersHaveTheirOwn) {
  Scene opaque({96, 96}), scene({96, 96});
  add_crease(opaque, "");
  scene.add("opacity.constant", "solid", R"({"alpha": 1})");
  scene.add("opacity.constant", "clear", R"({"alpha": 0})");
  add_crease(scene, "solid");
  scene.surface("window", lumen::testing::moved(*lumen::testing::rectangle(8, 8), {0, 0, 4}), R"({"opacity": "clear"})");
  const float wanted = opaque.layer("color").at(49, 48);
  scene.set("ssao.radius", "0.066");  // the window makes the scene larger
  scene.set("main.occluded_layers", "2");
  EXPECT_NEAR(scene.layer("color").at(49, 48), wanted, 0.05f);
  scene.set("main.occluded_layers", "1");
  EXPECT_NEAR(scene.layer("color").at(49, 48), 1.0f, 1e-3f) << "deeper layers share the last one's";
}

TEST(TransparentOcclusion, IsDrawnOnceAndAgainOnlyForWhatItReads) {
  Scene scene({64, 64});
  scene.add("opacity.constant", "half", R"({"alpha": 0.5})");
  add_crease(scene, "half");
  scene.picture();
  EXPECT_EQ(scene.runs("transparent layer 1"), 1);
  EXPECT_EQ(scene.runs("transparent 0/ssao"), 1);
  scene.set("ssao.bias", "0.1");
  scene.picture();
  EXPECT_EQ(scene.runs("transparent layer 1"), 1);
  EXPECT_EQ(scene.runs("transparent 0/ssao"), 2);
  EXPECT_EQ(scene.runs("weighted"), 2);
  scene.set("front.intensity", "0.5");
  scene.picture();
  EXPECT_EQ(scene.runs("transparent 0/ssao"), 2);
}

}  // namespace
