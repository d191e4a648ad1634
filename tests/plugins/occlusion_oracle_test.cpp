/// occlusion.ssao: what must be 0 is 0, what must not be is not.

#include <gtest/gtest.h>
#include <lumen/testing.h>

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

}  // namespace
