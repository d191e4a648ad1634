/// Terms and lights against their closed forms, at every covered pixel of a sphere, through the program's own path.

#include <cmath>

#include <gtest/gtest.h>
#include <lumen/testing.h>

#include "plugins/term_oracle.h"

namespace lumen::testing {
namespace {

TEST(Lighting, LambertAndBlinnAreTheClosedForms) { expect_closed_form_everywhere("diffuse.lambert", lambert_term, "specular.blinn", blinn_term); }

TEST(Lighting, LambertAndPhongAreTheClosedForms) { expect_closed_form_everywhere("diffuse.lambert", lambert_term, "specular.phong", phong_term); }

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
