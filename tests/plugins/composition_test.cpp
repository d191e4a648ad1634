/// How the host composes a frame: one lighting pass, and only what changed runs again.

#include <gtest/gtest.h>
#include <lumen/testing.h>

namespace {

using lumen::testing::Pixels;
using lumen::testing::Scene;

void add_three_styles(Scene& scene) {
  scene.add("ambient.constant", "ambient");
  scene.add("diffuse.lambert", "lambert");
  scene.add("specular.phong", "phong");
  scene.add("specular.blinn", "blinn");
  scene.surface("a", lumen::testing::moved(*lumen::testing::sphere(32, 0.3f), {-0.7f, 0, 0}), R"({"ambient": "ambient"})");
  scene.surface("b", lumen::testing::sphere(32, 0.3f), R"({"diffuse": "lambert", "specular": "phong"})");
  scene.surface("c", lumen::testing::moved(*lumen::testing::sphere(32, 0.3f), {0.7f, 0, 0}), R"({"diffuse": "lambert", "specular": "blinn"})");
}

TEST(Composition, ThreeStylesAreOneLightingPass) {
  Scene scene;
  add_three_styles(scene);
  scene.picture();
  EXPECT_EQ(scene.runs("lighting"), 1);
  EXPECT_EQ(scene.runs("geometry"), 1);
}

TEST(Composition, UnchangedViewRunsNothing) {
  Scene scene;
  add_three_styles(scene);
  scene.add("occlusion.ssao", "ssao");
  scene.add("compositor.vignette", "vignette");
  scene.picture();
  const int before = scene.runs("geometry") + scene.runs("ssao") + scene.runs("lighting") + scene.runs("vignette");
  scene.picture();
  EXPECT_EQ(scene.runs("geometry") + scene.runs("ssao") + scene.runs("lighting") + scene.runs("vignette"), before);
}

TEST(Composition, VignetteRunsItselfAlone) {
  Scene scene;
  add_three_styles(scene);
  scene.add("occlusion.ssao", "ssao");
  scene.add("compositor.background", "background");
  scene.add("compositor.vignette", "vignette");
  scene.picture();
  scene.set("vignette.softness", "0.7");
  scene.picture();
  EXPECT_EQ(scene.runs("vignette"), 2);
  for (const char* pass : {"geometry", "ssao", "lighting", "background"}) EXPECT_EQ(scene.runs(pass), 1) << pass;
}

TEST(Composition, LightRunsLightingAndWhatFollows) {
  Scene scene;
  add_three_styles(scene);
  scene.add("occlusion.ssao", "ssao");
  scene.add("compositor.vignette", "vignette");
  scene.picture();
  scene.set("front.intensity", "0.5");
  scene.picture();
  EXPECT_EQ(scene.runs("lighting"), 2);
  EXPECT_EQ(scene.runs("vignette"), 2);
  EXPECT_EQ(scene.runs("geometry"), 1);
  EXPECT_EQ(scene.runs("ssao"), 1);
}

TEST(Composition, MaterialColorLeavesTheGeometryAlone) {
  Scene scene;
  add_three_styles(scene);
  scene.picture();
  scene.set("b.diffuse_color", "[0, 0, 1]");
  scene.picture();
  EXPECT_EQ(scene.runs("geometry"), 1);
  EXPECT_EQ(scene.runs("lighting"), 2);
}

TEST(Composition, InstancesOfOneTypeHaveTheirOwnValues) {
  Scene scene;
  scene.add("ambient.constant", "dim", R"({"intensity": 0.25})");
  scene.add("ambient.constant", "bright", R"({"intensity": 1})");
  scene.surface("a", lumen::testing::moved(*lumen::testing::sphere(32, 0.4f), {-0.5f, 0, 0}), R"({"ambient": "dim", "ambient_color": [1, 1, 1]})");
  scene.surface("b", lumen::testing::moved(*lumen::testing::sphere(32, 0.4f), {0.5f, 0, 0}), R"({"ambient": "bright", "ambient_color": [1, 1, 1]})");
  const Pixels ambient = scene.layer("ambient");
  EXPECT_NEAR(ambient.at(17, 32), 0.25f, 1e-6f);
  EXPECT_NEAR(ambient.at(46, 32), 1.0f, 1e-6f);
}

TEST(Composition, AntialiasingIsTheMeanOfSamplesAndKeepsLayersAtPixelCenters) {
  Scene scene({32, 32});
  scene.add("ambient.constant", "ambient");
  scene.surface("wall", lumen::testing::rectangle(1.1f, 1.1f), R"({"ambient": "ambient", "ambient_color": [1, 1, 1]})");
  const Pixels depth = scene.layer("depth");
  scene.set("main.antialiasing", "16");
  const Pixels color = scene.picture();
  EXPECT_NEAR(color.rgba(16, 16).a, 1, 1e-6f);
  double covered = 0;
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) covered += color.rgba(x, y).a;
  EXPECT_NEAR(covered, 1.1 * 1.1 / (2.2 * 2.2) * 32 * 32, 6);
  EXPECT_EQ(lumen::testing::largest_difference(depth, scene.layer("depth")), 0);
}

TEST(Composition, OpacityWithoutTransparencyIsSaidAndDrawnOpaque) {
  Scene scene;
  scene.add("ambient.constant", "ambient");
  scene.add("opacity.constant", "alpha");
  scene.surface("ball", lumen::testing::sphere(), R"({"ambient": "ambient", "opacity": "alpha"})");
  EXPECT_EQ(scene.picture().rgba(32, 32).a, 1);
  bool named = false;
  for (const lumen::Problem& problem : scene.problems()) named = named || problem.instance == "ball";
  EXPECT_TRUE(named);
}

}  // namespace
