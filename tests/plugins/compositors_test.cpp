/// What holds for every compositor there is: sound pictures, neutral settings that change nothing, no needless runs.
#include <cmath>
#include <map>

#include <gtest/gtest.h>
#include <lumen/testing.h>

#include "plugins/installed_types.h"

namespace {

using lumen::testing::largest_difference;
using lumen::testing::Pixels;
using lumen::testing::Scene;

/// The settings that leave the picture as it is, of the compositors that have some.
const std::map<std::string, std::string> neutral = {
    {"compositor.vignette", R"({"radius": 3, "softness": 0.001})"}, {"compositor.silhouettes", R"({"opacity": 0})"}, {"compositor.fog", R"({"amount": 0})"},
    {"compositor.depth_of_field", R"({"aperture": 0})"},            {"compositor.depth_unsharp", R"({"strength": 0})"}, {"compositor.cast_shadows", R"({"strength": 0})"},
    {"compositor.halos", R"({"strength": 0})"},                     {"compositor.refraction", R"({"index": 1})"},
};

std::vector<std::string> compositors() { return lumenshop::installed_types(lumen::Kind::compositor); }

/// Opaque, transparent and empty pixels; the vignette before the tested one rounds to the half floats that it writes.
void fill(Scene& scene) {
  scene.add("ambient.constant", "ambient");
  scene.add("diffuse.lambert", "lambert");
  scene.add("opacity.constant", "half", R"({"alpha": 0.5})");
  scene.add("transparency.weighted", "weighted");
  scene.surface("ball", lumen::testing::sphere(48, 0.6f), R"({"ambient": "ambient", "diffuse": "lambert"})");
  scene.surface("wall", lumen::testing::moved(*lumen::testing::rectangle(1.4f, 0.8f), {0.2f, 0.1f, -0.7f}), R"({"ambient": "ambient", "diffuse": "lambert", "diffuse_color": [0, 0.4, 0.1]})");
  scene.surface("pane", lumen::testing::moved(*lumen::testing::rectangle(0.8f, 0.8f), {-0.5f, -0.5f, 0.8f}), R"({"ambient": "ambient", "diffuse": "lambert", "opacity": "half"})");
  scene.set("front.direction", "[0.5, 0.5, 1]");
  scene.add("compositor.vignette", "rounded", neutral.at("compositor.vignette"));
}

TEST(AllCompositors, MakeSoundPicturesOfClearAndOfFullOnes) {
  const Scene shared;  // the driver's context stays from scene to scene
  for (const std::string& type : compositors()) {
    Scene scene({48, 40});
    fill(scene);
    scene.add(type, "tested");
    const Pixels picture = scene.picture();
    EXPECT_TRUE(scene.problems().empty()) << type << ": " << scene.problems().front().message;
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 48; ++x) {
        const glm::vec4 pixel = picture.rgba(x, y);
        for (int c = 0; c < 4; ++c) ASSERT_TRUE(std::isfinite(pixel[c]) && pixel[c] >= 0) << type << " at " << x << " " << y;
        ASSERT_LE(pixel.a, 1.001f) << type;
        if (pixel.a == 0) { ASSERT_EQ(glm::vec3(pixel), glm::vec3(0)) << type << ": a clear pixel has no color"; }
      }
  }
}

TEST(AllCompositors, NeutralSettingsChangeNothing) {
  const Scene shared;
  const std::vector<std::string> there = compositors();
  for (const auto& [type, properties] : neutral) {
    if (std::find(there.begin(), there.end(), type) == there.end()) continue;
    Scene scene({48, 40});
    fill(scene);
    const Pixels before = scene.picture();
    scene.add(type, "tested", properties);
    EXPECT_LE(largest_difference(before, scene.picture()), 1e-6f) << type;
  }
}

TEST(AllCompositors, RunOnceWhileNothingChangesAndAloneWhenTheirsDoes) {
  const Scene shared;  // the driver's context stays from scene to scene
  for (const std::string& type : compositors()) {
    Scene scene({48, 40});
    fill(scene);
    scene.add(type, "tested");
    scene.picture();
    scene.picture();
    scene.set("main.time", "3");
    scene.picture();
    EXPECT_EQ(scene.runs("tested"), 1) << type;
    scene.set("front.color", "[1, 0.5, 0.5]");
    scene.picture();
    EXPECT_EQ(scene.runs("tested"), 2) << type;
    EXPECT_EQ(scene.runs("geometry"), 1) << type;
  }
}

TEST(AllCompositors, WorkOnAnEmptyView) {
  const Scene shared;  // the driver's context stays from scene to scene
  for (const std::string& type : compositors()) {
    Scene scene({16, 16});
    scene.add(type, "tested");
    const Pixels picture = scene.picture();
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x)
        for (int c = 0; c < 4; ++c) ASSERT_TRUE(std::isfinite(picture.rgba(x, y)[c])) << type;
    EXPECT_TRUE(scene.problems().empty()) << type << ": " << scene.problems().front().message;
  }
}

}  // namespace
