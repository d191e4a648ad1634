/// Terms and lights against their closed forms, at every covered pixel of a sphere, through the program's own path.

#include <cmath>

#include <gtest/gtest.h>
#include <lumen/testing.h>

#include "plugins/term_oracle.h"

namespace lumen::testing {
namespace {

TEST(Lighting, LambertAndBlinnAreTheClosedForms) { expect_closed_form_everywhere("diffuse.lambert", lambert_term, "specular.blinn", blinn_term); }

TEST(Lighting, LambertAndPhongAreTheClosedForms) { expect_closed_form_everywhere("diffuse.lambert", lambert_term, "specular.phong", phong_term); }

TEST(Lighting, LightsOfOneKindAndOfBothAddUp) {
  // A wall at the height 0.25: a point light above its middle, one that falls off with the square, a direction that is not unit.
  Scene scene({17, 17});
  scene.add("diffuse.lambert", "lambert");
  scene.surface("wall", moved(*rectangle(), {0, 0, 0.25f}), R"({"diffuse": "lambert", "diffuse_color": [1, 1, 1]})");
  scene.add("interactor.light", "slanted", R"({"direction": [0, 6, 8], "intensity": 0.5})");
  scene.add("interactor.light", "lamp", R"({"kind": "point", "position": [0, 0, 2.25], "intensity": 3, "falloff": "quadratic"})");
  scene.add("interactor.light", "lantern", R"({"kind": "point", "position": [0, 0, 4.25], "intensity": 1, "falloff": "linear"})");
  const float slanted = 0.5f * 0.8f, lamp = 3.0f / 4, lantern = 1.0f / 4;
  for (const auto& [lights, expected] : {std::pair(R"(["slanted"])", slanted), std::pair(R"(["lamp", "lantern"])", lamp + lantern),
                                         std::pair(R"(["slanted", "lamp"])", slanted + lamp), std::pair(R"(["lantern", "slanted"])", lantern + slanted)}) {
    scene.set("main.lights", lights);
    EXPECT_NEAR(scene.layer("diffuse").at(8, 8, 0), expected, 1e-5f) << lights;
  }
}

TEST(Lighting, DepthAndPositionAreWorldUnitsFromTheEye) {
  Scene scene({33, 33});
  scene.surface("wall", moved(*rectangle(), {0, 0, 0.25f}));
  EXPECT_NEAR(scene.layer("depth").at(16, 16), 9.75f, 1e-5f);
  EXPECT_TRUE(std::isinf(scene.layer("depth").at(0, 0)));
  const glm::vec3 corner = scene.layer("position").rgb(28, 4);
  EXPECT_NEAR(corner.x, 12 * 2.2f / 33, 1e-5f);
  EXPECT_NEAR(corner.y, 12 * 2.2f / 33, 1e-5f);
  EXPECT_NEAR(corner.z, 0.25f, 1e-5f);
}

TEST(Lighting, NormalsFaceTheEyeFromBehindToo) {
  Scene scene({17, 17});
  scene.surface("wall", rectangle(), R"({"transform": [-1,0,0,0, 0,1,0,0, 0,0,-1,0, 0,0,0,1]})");
  EXPECT_NEAR(scene.layer("normal").at(8, 8, 2), 1, 1e-6f);
}

TEST(Lighting, IdNamesInstancePartAndPrimitive) {
  Scene scene({17, 17});
  scene.surface("wall", rectangle());
  const Pixels id = scene.layer("id");
  EXPECT_GT(id.at(8, 8, 0), 0);
  EXPECT_EQ(id.at(8, 8, 1), 1);
  EXPECT_GE(id.at(8, 8, 2), 1);
  EXPECT_LE(id.at(8, 8, 2), 2);
  EXPECT_EQ(id.at(0, 0, 0), 0);
}

}  // namespace
}  // namespace lumen::testing
