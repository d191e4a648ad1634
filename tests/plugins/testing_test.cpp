/// lumen/testing.h itself: its meshes are exact, its scene is what it says.
#include <cmath>

#include <gtest/gtest.h>

#include <lumen/testing.h>

namespace lumen::testing {
namespace {

double enclosed_volume(const Mesh& mesh) {
  double volume = 0;
  for (const glm::uvec3 t : mesh.triangles)
    volume += glm::dot(glm::dvec3(mesh.positions[t.x]), glm::cross(glm::dvec3(mesh.positions[t.y]), glm::dvec3(mesh.positions[t.z]))) / 6;
  return volume;
}

TEST(TestingMeshes, EncloseTheirVolumesFromOutside) {
  EXPECT_NEAR(enclosed_volume(*sphere(256)), 4 * std::acos(-1.0) / 3, 2e-3);
  EXPECT_NEAR(enclosed_volume(*box({1, 2, 3})), 6, 1e-6);
  EXPECT_NEAR(enclosed_volume(*moved(*box({1, 2, 3}), {5, 6, 7})), 6, 1e-4);
  EXPECT_NEAR(enclosed_volume(*joined({box({1, 1, 1}), box({2, 2, 2})})), 9, 1e-6);
}

TEST(TestingMeshes, HaveNormalsThatPointOutward) {
  for (const auto& mesh : {sphere(16), box()})
    for (std::size_t i = 0; i < mesh->positions.size(); ++i) {
      EXPECT_GT(glm::dot(mesh->positions[i], mesh->normals[i]), 0);
      EXPECT_NEAR(glm::length(mesh->normals[i]), 1, 1e-5);
    }
  EXPECT_EQ(rectangle()->normals[0], glm::vec3(0, 0, 1));
}

TEST(TestingScene, ShowsAUnitSphereFromTenUnitsAway) {
  Scene scene({110, 110});
  scene.surface("ball", sphere(256));
  const Pixels depth = scene.layer("depth");
  ASSERT_EQ(depth.width(), 110);
  EXPECT_NEAR(depth.at(55, 55), 9.0f, 1e-3f);
  EXPECT_TRUE(std::isinf(depth.at(0, 0)));
  EXPECT_TRUE(std::isinf(depth.at(55, 3)));  // 2.2 units on 110 pixels: the sphere ends 50 pixels from the middle
  EXPECT_FALSE(std::isinf(depth.at(55, 7)));
  const Pixels normal = scene.layer("normal");
  EXPECT_NEAR(normal.at(55, 55, 2), 1.0f, 1e-3f);
  EXPECT_GT(normal.at(90, 55, 0), 0.5f);     // x to the right
  EXPECT_GT(normal.at(55, 20, 1), 0.5f);     // y up, rows from the top
  EXPECT_THROW(depth.at(110, 0), Error);
}

TEST(TestingScene, GivesPositionsInTheWorld) {
  Scene scene({110, 110});
  scene.surface("ball", moved(*sphere(256, 0.5f), {0.2f, 0, 0.25f}));
  const Pixels position = scene.layer("position");
  EXPECT_NEAR(position.at(65, 55, 0), 0.21f, 1e-2f);  // a pixel is 0.02 units
  EXPECT_NEAR(position.at(65, 55, 2), 0.75f, 1e-3f);
  EXPECT_TRUE(std::isinf(position.at(0, 0, 0)));
}

TEST(TestingScene, LightsFromTheEye) {
  Scene scene({64, 64});
  scene.surface("ball", sphere(256), R"({"diffuse": "lambert", "diffuse_color": [0.5, 0.25, 1], "ambient_color": [0, 0, 0]})");
  scene.add("diffuse.lambert", "lambert");
  const Pixels picture = scene.picture();
  EXPECT_NEAR(picture.at(32, 32, 0), 0.5f, 1e-3f);
  EXPECT_NEAR(picture.at(32, 32, 1), 0.25f, 1e-3f);
  EXPECT_TRUE(scene.problems().empty());
}

TEST(TestingScene, TakesValuesAsTextAndGivesThemBack) {
  Scene scene;
  scene.add("opacity.constant", "term");
  scene.set("term.alpha", "0.25");
  EXPECT_FLOAT_EQ(std::get<float>(scene.value("term.alpha")), 0.25f);
  scene.set_value("term.alpha", 0.75f);
  EXPECT_FLOAT_EQ(std::get<float>(scene.value("term.alpha")), 0.75f);
  EXPECT_THROW(scene.set("term.beta", "1"), Error);
  EXPECT_THROW(scene.add("opacity.nowhere", "other"), Error);
}

TEST(TestingScene, ReplacesDataThatIsGivenAgain) {
  Scene scene({110, 110});
  scene.surface("ball", sphere(128, 0.5f));
  EXPECT_NEAR(scene.layer("depth").at(55, 55), 9.5f, 1e-3f);
  scene.give("ball_data", sphere(128, 0.25f));
  EXPECT_NEAR(scene.layer("depth").at(55, 55), 9.75f, 1e-3f);
}

TEST(TestingScene, TwoLiveSideBySide) {
  Scene a({32, 32}), b({32, 32});
  a.surface("ball", sphere(64, 1));
  b.surface("ball", sphere(64, 0.5f));
  EXPECT_NEAR(a.layer("depth").at(16, 16), 9.0f, 1e-2f);
  EXPECT_NEAR(b.layer("depth").at(16, 16), 9.5f, 1e-2f);
  EXPECT_FLOAT_EQ(largest_difference(a.layer("depth"), a.layer("depth")), 0);
}

}  // namespace
}  // namespace lumen::testing
