/// How the host composes a frame: one lighting pass, and only what changed runs again.
#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <lumen/testing.h>

namespace {

using lumen::testing::Pixels;
using lumen::testing::Scene;

/// Three surfaces of three styles, with an occlusion, a background and a vignette: a pass of every sort.
class ThreeStyles : public testing::Test {
 protected:
  ThreeStyles() {
    scene.add("ambient.constant", "ambient");
    scene.add("diffuse.lambert", "lambert");
    scene.add("specular.phong", "phong");
    scene.add("specular.blinn", "blinn");
    scene.surface("a", lumen::testing::moved(*lumen::testing::sphere(32, 0.3f), {-0.7f, 0, 0}), R"({"ambient": "ambient"})");
    scene.surface("b", lumen::testing::sphere(32, 0.3f), R"({"diffuse": "lambert", "specular": "phong"})");
    scene.surface("c", lumen::testing::moved(*lumen::testing::sphere(32, 0.3f), {0.7f, 0, 0}), R"({"diffuse": "lambert", "specular": "blinn"})");
    scene.add("occlusion.ssao", "ssao");
    scene.add("compositor.background", "background");
    scene.add("compositor.vignette", "vignette");
    scene.picture();
  }

  /// Draws again; the passes that ran for it, in the frame's order.
  std::vector<std::string> passes_after(const char* property, const char* value) {
    const std::vector<int> before = runs();
    scene.set(property, value);
    return passes_since(before);
  }
  std::vector<std::string> passes_since(const std::vector<int>& before) {
    scene.picture();
    std::vector<std::string> ran;
    const std::vector<int> after = runs();
    for (std::size_t pass = 0; pass < after.size(); ++pass)
      for (int run = before[pass]; run < after[pass]; ++run) ran.push_back(passes[pass]);
    return ran;
  }
  std::vector<int> runs() const {
    std::vector<int> counts;
    for (const char* pass : passes) counts.push_back(scene.runs(pass));
    return counts;
  }

  static constexpr std::array passes = {"geometry", "ssao", "lighting", "background", "vignette"};
  Scene scene;
};
using Passes = std::vector<std::string>;

TEST_F(ThreeStyles, AreOneLightingPass) { EXPECT_EQ(runs(), std::vector<int>(passes.size(), 1)); }

TEST_F(ThreeStyles, UnchangedRunNothing) { EXPECT_EQ(passes_since(runs()), Passes{}); }

TEST_F(ThreeStyles, WithAnotherVignetteRunItAlone) { EXPECT_EQ(passes_after("vignette.softness", "0.7"), Passes{"vignette"}); }

TEST_F(ThreeStyles, WithAnotherLightRunLightingAndWhatFollows) {
  EXPECT_EQ(passes_after("front.intensity", "0.5"), (Passes{"lighting", "background", "vignette"}));
}

TEST_F(ThreeStyles, WithAnotherColorLeaveTheGeometryAlone) {
  EXPECT_EQ(passes_after("b.diffuse_color", "[0, 0, 1]"), (Passes{"lighting", "background", "vignette"}));
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
