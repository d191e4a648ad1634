/// occlusion.ssao: what must be 0 is 0, what must not be is not. occlusion.hbao: what its integral gives, which no cosine weights.
/// occlusion.voxel: closed forms, as near as voxels come.

#include <gtest/gtest.h>
#include <lumen/testing.h>

#include "occluders.h"

namespace {

using lumen::testing::Pixels;
using lumen::testing::Scene;

constexpr const char* turned_by_60 = R"({"ambient": "ambient", "transform": [1,0,0,0, 0,0.5,-0.8660254,0, 0,0.8660254,0.5,0, 0,0,0,1]})";

float largest(const Pixels& occlusion) {
  float most = 0;
  for (int y = 0; y < occlusion.height(); ++y)
    for (int x = 0; x < occlusion.width(); ++x) most = std::max(most, occlusion.at(x, y));
  return most;
}

TEST(Ssao, PlaneThatFacesTheEyeIsNotOccluded) {
  Scene scene({96, 96});
  scene.surface("wall", lumen::testing::rectangle(6, 6));
  scene.add("occlusion.ssao", "ssao", R"({"radius": 0.2})");
  EXPECT_LE(largest(scene.layer("occlusion")), 1.0f / 255);
}

TEST(Ssao, TiltedPlaneIsNotOccluded) {
  for (const char* radius : {"0.02", "0.1", "0.5"}) {
    Scene scene({96, 96});
    scene.surface("wall", lumen::testing::rectangle(6, 6), turned_by_60);
    scene.add("ambient.constant", "ambient");
    scene.add("occlusion.ssao", "ssao");
    scene.set("ssao.radius", radius);
    EXPECT_LE(largest(scene.layer("occlusion")), 1.0f / 255) << "radius " << radius;
    scene.set("camera.projection", "perspective");
    EXPECT_LE(largest(scene.layer("occlusion")), 1.0f / 255) << "perspective, radius " << radius;
  }
}

TEST(Ssao, CreaseIsDarkerThanThePlaneAndReachesNoFartherThanTheRadius) {
  Scene scene({128, 128});
  // Two rectangles that meet at a right angle along x = 0.
  scene.surface("left", lumen::testing::rectangle(4, 4), R"({"transform": [0.7071068,0,0.7071068,-1.4142, 0,1,0,0, -0.7071068,0,0.7071068,1.4142, 0,0,0,1]})");
  scene.surface("right", lumen::testing::rectangle(4, 4), R"({"transform": [0.7071068,0,-0.7071068,1.4142, 0,1,0,0, 0.7071068,0,0.7071068,1.4142, 0,0,0,1]})");
  scene.add("occlusion.ssao", "ssao", R"({"radius": 0.1, "samples": 64})");
  const Pixels occlusion = scene.layer("occlusion");
  EXPECT_GT(occlusion.at(66, 64), 0.15f);
  EXPECT_LT(occlusion.at(110, 64), 1.0f / 255);
}

TEST(Ssao, MultipliesTheAmbientLightAlone) {
  Scene scene({128, 128});
  scene.surface("left", lumen::testing::rectangle(4, 4), R"({"ambient": "ambient", "diffuse": "diffuse", "transform": [0.7071068,0,0.7071068,-1.4142, 0,1,0,0, -0.7071068,0,0.7071068,1.4142, 0,0,0,1]})");
  scene.surface("right", lumen::testing::rectangle(4, 4), R"({"ambient": "ambient", "diffuse": "diffuse", "transform": [0.7071068,0,-0.7071068,1.4142, 0,1,0,0, 0.7071068,0,0.7071068,1.4142, 0,0,0,1]})");
  scene.add("ambient.constant", "ambient");
  scene.add("diffuse.lambert", "diffuse");
  const Pixels open_ambient = scene.layer("ambient"), open_diffuse = scene.layer("diffuse");
  scene.add("occlusion.ssao", "ssao", R"({"radius": 0.1})");
  const Pixels occlusion = scene.layer("occlusion"), ambient = scene.layer("ambient"), diffuse = scene.layer("diffuse");
  ASSERT_GT(occlusion.at(66, 64), 0.1f);
  EXPECT_NEAR(ambient.at(66, 64), open_ambient.at(66, 64) * (1 - occlusion.at(66, 64)), 1e-5f);
  EXPECT_EQ(diffuse.at(66, 64), open_diffuse.at(66, 64));
}

TEST(Ssao, BiasHidesAndFalloffFadesOccluders) {
  Scene scene({128, 128});
  scene.surface("step", occluders::wall(0.5f));
  scene.add("occlusion.ssao", "ssao", R"({"radius": 0.1, "samples": 64})");
  const float foot = scene.layer("occlusion").at(62, 64);
  scene.set("ssao.falloff", "false");  // the step is more than two radii high
  EXPECT_GT(scene.layer("occlusion").at(62, 64), foot + 0.1f);
  scene.set("ssao.bias", "2");
  scene.set("ssao.radius", "0.2");
  EXPECT_LT(scene.layer("occlusion").at(62, 64), 0.01f);
}

TEST(Hbao, CreaseSeenAlongItsBisectorIsLinearInItsAngle) {
  float before = 1;
  for (const float degrees : {30.0f, 60.0f, 90.0f, 120.0f, 150.0f}) {
    Scene scene({128, 128});
    scene.surface("crease", occluders::crease(degrees));
    scene.add("occlusion.hbao", "hbao", R"({"radius": 4, "falloff": false, "bias": 0, "directions": 8, "steps": 24, "refinements": 4})");
    const float occlusion = occluders::mean(scene.layer("occlusion"), 60, 56, 68, 72);
    EXPECT_NEAR(occlusion, 1 - degrees / 180, 0.05f) << degrees;
    EXPECT_LT(occlusion, before) << degrees;
    before = occlusion;
  }
}

/// Facing the eye, the horizon's sine instead of its square: darker than the cosine-weighted truth.
TEST(Hbao, PitIsAsDarkAsTheSineOfItsHorizon) {
  Scene scene({128, 128});
  scene.surface("pit", occluders::pit(0.6f, 0.3f));
  scene.add("occlusion.hbao", "hbao", R"({"radius": 4, "falloff": false, "bias": 0, "directions": 8, "steps": 24, "refinements": 4})");
  EXPECT_NEAR(occluders::mean(scene.layer("occlusion"), 56, 56, 72, 72), 1 / std::sqrt(5.0f), 0.05f);
}

TEST(Hbao, AngleBiasHidesWhatRisesLess) {
  Scene scene({96, 96});
  scene.surface("crease", occluders::crease(165));  // 7.5 degrees on either side, 15 over the tangent
  scene.add("occlusion.hbao", "hbao", R"({"radius": 4, "falloff": false, "bias": 20, "refinements": 1})");
  EXPECT_EQ(largest(scene.layer("occlusion")), 0);
  scene.set("hbao.bias", "0");
  EXPECT_GT(largest(scene.layer("occlusion")), 0.05f);
}

TEST(Voxel, PitIsTheClosedForm) {
  Scene pit({128, 128});
  pit.surface("pit", occluders::pit(0.6f, 0.6f));
  pit.add("occlusion.voxel", "voxel", R"({"radius": 4, "falloff": false, "thickness": 4, "rays": 16, "steps": 128, "refinements": 4})");
  EXPECT_NEAR(occluders::mean(pit.layer("occlusion"), 56, 56, 72, 72), 0.5f, 0.1f);
  EXPECT_TRUE(pit.problems().empty());
}

TEST(Voxel, CreaseIsTheClosedFormAVoxelAwayFromIt) {
  Scene scene({128, 128});
  scene.surface("crease", occluders::crease(90));
  scene.add("occlusion.voxel", "voxel", R"({"radius": 4, "falloff": false, "thickness": 4, "rays": 16, "steps": 128, "refinements": 4})");
  const auto wall_of_length = [](float x) { return 0.5f * (1 - 1 / std::sqrt(1 + 1.21f / (x * x))); };  // it ends at x = 1.1
  EXPECT_NEAR(occluders::mean(scene.layer("occlusion"), 72, 56, 84, 72), occluders::mean_of(wall_of_length, 72, 84, 128), 0.08f);
}

}  // namespace
