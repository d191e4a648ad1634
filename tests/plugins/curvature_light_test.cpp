/// interactor.curvature_light: its highlights lie where a surface bends, as reflection has it.

#include <cmath>

#include <gtest/gtest.h>
#include <lumen/interactor.h>
#include <lumen/testing.h>

namespace {

using lumen::testing::Scene;

/// Three small plates that face the camera askew, whose array says how much they bend: the last one not at all.
std::shared_ptr<lumen::Mesh> plates(const std::vector<glm::vec3>& normals, const std::vector<float>& curvatures) {
  auto mesh = std::make_shared<lumen::Mesh>();
  std::vector<glm::vec3> positions, point_normals;
  std::vector<glm::uvec3> triangles;
  std::vector<float> values;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const glm::vec3 n = glm::normalize(normals[i]), u = glm::normalize(glm::cross(n, glm::vec3(0.3f, 1, 0.2f))), v = glm::cross(n, u);
    const auto first = std::uint32_t(positions.size());
    for (const glm::vec2 corner : {glm::vec2(0, 0), glm::vec2(0.1f, 0), glm::vec2(0, 0.1f)}) {
      positions.push_back(glm::vec3(float(i) - 1, 0, 0) + corner.x * u + corner.y * v);
      point_normals.push_back(n);
      values.push_back(curvatures[i]);
    }
    triangles.emplace_back(first, first + 1, first + 2);
  }
  mesh->positions = std::move(positions);
  mesh->normals = std::move(point_normals);
  mesh->triangles = std::move(triangles);
  mesh->attributes.push_back({"mean_curvature", lumen::Attribute::On::points, 1, std::move(values)});
  mesh->finish();
  return mesh;
}

/// The direction of light `number` of `lights`, as the scene's camera sees the mesh, which is along -z.
lumen::Light light_of(Scene& scene, const char* properties) {
  auto& light = static_cast<lumen::Interactor&>(scene.add("interactor.curvature_light", "own", properties));
  scene.set("own.mesh", R"({"link": "surface_data.mesh"})");
  scene.layer("color");
  lumen::Camera camera;
  camera.orthographic = true;
  return light.light(camera);
}

TEST(CurvatureLight, HighlightsWhatBendsMostFirst) {
  const std::vector<glm::vec3> normals = {{0.4f, 0.1f, 1}, {-0.5f, 0.3f, 1}, {0, -0.6f, 1}};
  for (const int number : {0, 1, 2}) {
    Scene scene;
    scene.surface("surface", plates(normals, {1, -3, 0}));
    const lumen::Light light = light_of(scene, ("{\"lights\": 2, \"widest\": 80, \"intensity\": 1, \"number\": " + std::to_string(number) + "}").c_str());
    if (number == 2) {
      EXPECT_EQ(light.color, glm::vec3(0)) << "there are two";
      continue;
    }
    const glm::vec3 n = glm::normalize(normals[number == 0 ? 1 : 0]);
    EXPECT_LT(glm::distance(light.direction, 2 * n.z * n - glm::vec3(0, 0, 1)), 1e-5f) << number;
    EXPECT_EQ(light.color, glm::vec3(1));
  }
}

TEST(CurvatureLight, StaysWithinItsAngleFromTheEye) {
  Scene scene;
  scene.surface("surface", plates({{2, 0, 1}}, {1}));  // its highlight wants a light from behind
  const lumen::Light light = light_of(scene, R"({"lights": 1, "widest": 50})");
  EXPECT_NEAR(light.direction.z, std::cos(50 * 3.14159265f / 180), 1e-5f);
  EXPECT_NEAR(light.direction.x, std::sin(50 * 3.14159265f / 180), 1e-5f);
}

TEST(CurvatureLight, OfABallShinesFromTheEye) {
  Scene scene;
  scene.surface("surface", lumen::testing::sphere(64));
  const lumen::Light light = light_of(scene, R"({"lights": 1})");
  EXPECT_GT(light.direction.z, 0.999f) << "all places of a ball are alike";
}

TEST(CurvatureLight, MovesTheHighlightOntoThePlateThatBends) {
  // The specular term is the largest where the normal halves the angle between eye and light.
  Scene scene({96, 96});
  scene.add("specular.phong", "phong");
  scene.surface("surface", plates({{0.5f, 0, 1}, {-0.5f, 0.2f, 1}}, {0, 1}), R"({"specular": "phong", "shininess": 200})");
  scene.set("camera.height", "3");
  const lumen::Light light = light_of(scene, R"({"lights": 1, "intensity": 1})");
  scene.set("main.lights", R"(["own"])");
  const lumen::testing::Pixels specular = scene.layer("specular"), id = scene.layer("id");
  float bends = 0, flat = 0;
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 96; ++x)
      if (id.at(x, y, 0) > 0) (x < 40 ? flat : bends) = std::max(x < 40 ? flat : bends, specular.at(x, y));
  EXPECT_GT(bends, 0.3f);
  EXPECT_LT(flat, 0.01f * bends);
  EXPECT_LT(light.direction.x, 0);
}

}  // namespace
