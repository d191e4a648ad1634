/// The physically meant occlusions against closed forms: cosine-weighted, unlimited radius, all occluders in the picture.

#include <gtest/gtest.h>

#include "occluders.h"

namespace {

using lumen::testing::Pixels;
using lumen::testing::Scene;

constexpr int size = 128;
struct Technique {
  const char* type;
  const char* properties;
  float tolerance;
};

class ClosedForm : public testing::TestWithParam<Technique> {
 protected:
  void look_in_perspective() {
    scene_.set("camera.projection", "perspective");
    scene_.set("camera.distance", "3");
    scene_.set("camera.field_of_view", "40");
  }
  Pixels occlusion_of(const std::shared_ptr<lumen::Mesh>& mesh) {
    scene_.surface("surface", mesh);
    scene_.add(GetParam().type, "ao", GetParam().properties);
    Pixels layer = scene_.layer("occlusion");
    EXPECT_TRUE(scene_.problems().empty());
    return layer;
  }
  /// Over the 16x16 pixels in the middle.
  float in_the_middle(const std::shared_ptr<lumen::Mesh>& mesh) { return occluders::mean(occlusion_of(mesh), size / 2 - 8, size / 2 - 8, size / 2 + 8, size / 2 + 8); }

 private:
  Scene scene_{{size, size}};
};

INSTANTIATE_TEST_SUITE_P(, ClosedForm,
                         testing::Values(Technique{"occlusion.gtao", R"({"radius": 4, "falloff": false, "slices": 2, "steps": 24, "refinements": 4})", 0.08f},
                                         Technique{"occlusion.bitmask", R"({"radius": 4, "falloff": false, "thickness": 4, "slices": 2, "steps": 24, "refinements": 4})", 0.08f},
                                         Technique{"occlusion.traced", R"({"samples": 1024, "samples_per_step": 256})", 0.03f}),
                         [](const auto& parameter) { return std::string(parameter.param.type).substr(10); });

#define CREASE(DEGREES)                                                                                          \
  TEST_P(ClosedForm, CreaseOf##DEGREES##Degrees) {                                                               \
    const Pixels layer = occlusion_of(occluders::crease(DEGREES));                                               \
    const float expected = (1 + std::cos(DEGREES * occluders::pi / 180)) / 2;                                    \
    EXPECT_NEAR(occluders::mean(layer, size / 2 - 4, size / 2 - 8, size / 2 + 4, size / 2 + 8), expected, GetParam().tolerance); \
  }
CREASE(45)
CREASE(60)
CREASE(90)
CREASE(120)
CREASE(150)

TEST_P(ClosedForm, CreaseInPerspective) {
  look_in_perspective();
  // Rays miss the planes beyond their ends, which the formula does not have.
  EXPECT_NEAR(in_the_middle(occluders::crease(100)), (1 + std::cos(100 * occluders::pi / 180)) / 2, GetParam().tolerance + 0.01f);
}

TEST_P(ClosedForm, BowlInPerspective) {
  look_in_perspective();
  EXPECT_NEAR(in_the_middle(occluders::bowl(0.8f, 0.4f)), 0.25f, GetParam().tolerance);
}

TEST_P(ClosedForm, FootOfAWall) {
  constexpr float height = 0.4f;
  const Pixels layer = occlusion_of(occluders::wall(height));
  for (const int distance : {4, 12, 28}) {
    const int x = size / 2 - distance;
    const auto formula = [](float at) { return 0.5f * (1 - 1 / std::sqrt(1 + height * height / (at * at))); };
    EXPECT_NEAR(occluders::mean(layer, x - 4, size / 2 - 8, x + 4, size / 2 + 8), occluders::mean_of(formula, x - 4, x + 4, size), GetParam().tolerance) << distance;
  }
}

TEST_P(ClosedForm, ShallowBowlIsEvenlyDark) {
  const Pixels layer = occlusion_of(occluders::bowl(0.8f, 0.4f));  // its rim: .69
  for (const int x : {size / 2, size / 2 + 12, size / 2 + 24}) EXPECT_NEAR(occluders::mean(layer, x - 8, size / 2 - 8, x + 8, size / 2 + 8), 0.25f, GetParam().tolerance) << x;
}

TEST_P(ClosedForm, HemisphericalBowl) { EXPECT_NEAR(in_the_middle(occluders::bowl(0.8f, 0.8f)), 0.5f, GetParam().tolerance); }
TEST_P(ClosedForm, ShallowPit) { EXPECT_NEAR(in_the_middle(occluders::pit(0.6f, 0.3f)), 0.2f, GetParam().tolerance); }
TEST_P(ClosedForm, DeepPit) { EXPECT_NEAR(in_the_middle(occluders::pit(0.6f, 0.9f)), 1 - 1 / 3.25f, GetParam().tolerance); }
TEST_P(ClosedForm, ShallowTrench) { EXPECT_NEAR(in_the_middle(occluders::trench(0.5f, 0.4f)), 1 - 1 / std::sqrt(1.64f), GetParam().tolerance); }
TEST_P(ClosedForm, DeepTrench) { EXPECT_NEAR(in_the_middle(occluders::trench(0.35f, 0.7f)), 1 - 1 / std::sqrt(5.0f), GetParam().tolerance); }

TEST(Traced, SphereOnAPlane) {
  constexpr float radius = 0.25f;
  Scene scene({size, size});
  scene.surface("surface", lumen::testing::joined({lumen::testing::rectangle(2.2f, 2.2f), lumen::testing::moved(*lumen::testing::sphere(256, radius), {0, 0, radius})}));
  scene.add("occlusion.traced", "ao", R"({"samples": 1024, "samples_per_step": 256})");
  const Pixels layer = scene.layer("occlusion");
  for (const int offset : {18, 24, 36}) {  // in pixels; the ball covers 14.5
    const auto formula = [&](float x) { return std::pow(1 + x * x / (radius * radius), -1.5f); };
    const int x = size / 2 + offset;
    EXPECT_NEAR(occluders::mean(layer, x - 2, size / 2 - 2, x + 2, size / 2 + 2), occluders::mean_of(formula, x - 2, x + 2, size), 0.03f) << offset;
  }
}

TEST(Traced, TubeOverAPlane) {
  constexpr float radius = 0.12f, height = 0.36f;
  Scene scene({size, size});
  scene.surface("surface", occluders::tube_over_plane(radius, height));
  scene.add("occlusion.traced", "ao", R"({"samples": 1024, "samples_per_step": 256})");
  const Pixels layer = scene.layer("occlusion");
  const auto formula = [](float x) { return height * radius / (height * height + x * x); };
  for (const int offset : {14, 20, 30, 42}) {
    const int x = size / 2 + offset;
    EXPECT_NEAR(occluders::mean(layer, x - 4, size / 2 - 8, x + 4, size / 2 + 8), occluders::mean_of(formula, x - 4, x + 4, size), 0.03f) << offset;
  }
}

TEST(Traced, RaysSeeWhatTheCameraDoesNot) {
  Scene scene({64, 64});
  scene.set("camera.projection", "perspective");
  scene.surface("floor", lumen::testing::rectangle());
  scene.add("occlusion.traced", "ao", R"({"samples": 64, "samples_per_step": 64})");
  EXPECT_EQ(scene.layer("occlusion").at(32, 32), 0);
  scene.surface("roof", lumen::testing::moved(*lumen::testing::rectangle(40, 40), {0, 0, 20}));  // behind the camera
  EXPECT_GT(scene.layer("occlusion").at(32, 32), 0.4f);
}

TEST(Traced, SplitPartsAreCutAndMoved) {
  Scene scene({64, 64});
  scene.set("camera.projection", "perspective");
  scene.surface("floor", lumen::testing::rectangle());
  scene.surface("roof", lumen::testing::moved(*lumen::testing::rectangle(40, 40), {0, 0, 20}), R"({"splitter": "cut"})");
  scene.add("occlusion.traced", "ao", R"({"samples": 64, "samples_per_step": 64})");
  const float closed = scene.layer("occlusion").at(32, 32);
  // The normal turned to +x; the halves open by 30 on each side and let the light through between them.
  scene.add("splitter.plane", "cut", R"({"axis": [0, 1, 0], "angle": 90, "offset": 30})");
  EXPECT_LT(scene.layer("occlusion").at(32, 32), closed - 0.3f);
}

TEST(Bitmask, TubeOverAPlaneLetsTheLightPassBelow) {
  constexpr float radius = 0.12f, height = 0.36f;
  const auto mesh = occluders::tube_over_plane(radius, height);
  Scene scene({size, size});
  scene.surface("surface", mesh);
  // A disk is as thick as its area over its width in the mean.
  const float thickness = 0.5f * occluders::pi * radius / mesh->bounds().radius();
  scene.add("occlusion.bitmask", "ao", R"({"radius": 4, "falloff": false, "slices": 2, "steps": 24, "refinements": 4})");
  scene.set_value("ao.thickness", lumen::Value(thickness));
  const Pixels layer = scene.layer("occlusion");
  const auto formula = [](float x) { return height * radius / (height * height + x * x); };
  for (const int offset : {14, 20, 30, 42}) {
    const int x = size / 2 + offset;
    EXPECT_NEAR(occluders::mean(layer, x - 4, size / 2 - 8, x + 4, size / 2 + 8), occluders::mean_of(formula, x - 4, x + 4, size), 0.08f) << offset;
  }
  scene.set("ao.thickness", "4");  // a wall instead of a tube
  EXPECT_GT(scene.layer("occlusion").at(size / 2 + 14, size / 2), layer.at(size / 2 + 14, size / 2) + 0.05f);
}

}  // namespace
