/// Terms and lights against their closed forms, at every covered pixel of a sphere, through the program's own path.

#include <cmath>
#include <functional>

#include <gtest/gtest.h>
#include <lumen/testing.h>

namespace {

using lumen::testing::Pixels;
using lumen::testing::Scene;

constexpr float tolerance = 1e-4f;

struct TestLight {
  glm::vec3 direction{0, 0, 1};  // toward the light, unit
  glm::vec3 position{0};
  bool point = false;
  glm::vec3 color{1};
  std::function<float(float)> falloff = [](float) { return 1.0f; };
};

const glm::vec3 ambient_color(0.2f, 0.1f, 0.05f), diffuse_color(0.7f, 0.3f, 0.2f), specular_color(0.5f, 0.6f, 0.7f);
constexpr float shininess = 20;

std::string json(glm::vec3 v) { return "[" + std::to_string(v.x) + "," + std::to_string(v.y) + "," + std::to_string(v.z) + "]"; }

/// A sphere with these terms; the camera looks along -z, so view space is world space moved along z.
void add_ball(Scene& scene, const std::string& specular) {
  scene.surface("ball", lumen::testing::sphere(96),
                R"({"ambient": "ambient", "diffuse": "diffuse", "specular": "specular", "ambient_color": )" + json(ambient_color) +
                    R"(, "diffuse_color": )" + json(diffuse_color) + R"(, "specular_color": )" + json(specular_color) + R"(, "shininess": 20})");
  scene.add("ambient.constant", "ambient");
  scene.add("diffuse.lambert", "diffuse");
  scene.add(specular, "specular");
}

using Highlight = float (*)(glm::vec3 n, glm::vec3 l, glm::vec3 v);

float halfway_term(glm::vec3 n, glm::vec3 l, glm::vec3 v) { return std::pow(std::max(0.0f, glm::dot(n, glm::normalize(l + v))), shininess); }
float mirror_term(glm::vec3 n, glm::vec3 l, glm::vec3 v) {
  return std::pow(std::max(0.0f, glm::dot(2 * glm::dot(n, l) * n - l, v)), shininess);
}

/// Compares all layers with the closed form; the camera looks along -z, so the axes of view and world agree.
void expect_closed_form(Scene& scene, const std::vector<TestLight>& lights, Highlight highlight) {
  const Pixels normal = scene.layer("normal"), position = scene.layer("position"), ambient = scene.layer("ambient"),
               diffuse = scene.layer("diffuse"), specular = scene.layer("specular"), color = scene.layer("color");
  int covered = 0;
  for (int y = 0; y < normal.height(); ++y) {
    for (int x = 0; x < normal.width(); ++x) {
      const glm::vec3 n = normal.rgb(x, y);
      if (n == glm::vec3(0)) {
        ASSERT_EQ(color.rgba(x, y).a, 0) << "background at " << x << ", " << y;
        continue;
      }
      ++covered;
      const glm::vec3 place = position.rgb(x, y), eye(0, 0, 1);
      glm::vec3 wanted_diffuse(0), wanted_specular(0);
      for (const TestLight& light : lights) {
        const glm::vec3 path = light.point ? light.position - place : light.direction;
        const glm::vec3 l = glm::normalize(path), radiance = light.color / (light.point ? light.falloff(glm::length(path)) : 1.0f);
        wanted_diffuse += diffuse_color * radiance * std::max(0.0f, glm::dot(n, l));
        if (glm::dot(n, l) > 0) wanted_specular += specular_color * radiance * highlight(n, l, eye);
      }
      for (int c = 0; c < 3; ++c) {
        ASSERT_NEAR(ambient.at(x, y, c), ambient_color[c], tolerance) << x << ", " << y;
        ASSERT_NEAR(diffuse.at(x, y, c), wanted_diffuse[c], tolerance) << x << ", " << y;
        ASSERT_NEAR(specular.at(x, y, c), wanted_specular[c], tolerance) << x << ", " << y;
        ASSERT_NEAR(color.at(x, y, c), ambient_color[c] + wanted_diffuse[c] + wanted_specular[c], 2 * tolerance);
      }
    }
  }
  EXPECT_GT(covered, normal.width() * normal.height() / 2);
}

const glm::vec3 slanted = glm::normalize(glm::vec3(0.4f, 0.5f, 0.6f));

TEST(Lighting, BlinnUnderOneDirectionalLightIsTheClosedForm) {
  Scene scene;
  add_ball(scene, "specular.blinn");
  scene.set("front.direction", json(slanted));
  expect_closed_form(scene, {{.direction = slanted}}, halfway_term);
}

TEST(Lighting, PhongUnderOneDirectionalLightIsTheClosedForm) {
  Scene scene;
  add_ball(scene, "specular.phong");
  scene.set("front.direction", json(slanted));
  expect_closed_form(scene, {{.direction = slanted}}, mirror_term);
}

TEST(Lighting, TwoLightsAddUp) {
  for (const auto& [type, highlight] : {std::pair<const char*, Highlight>("specular.blinn", halfway_term), std::pair<const char*, Highlight>("specular.phong", mirror_term)}) {
    Scene scene;
    add_ball(scene, type);
    const glm::vec3 other = glm::normalize(glm::vec3(-0.8f, -0.1f, 0.2f));
    scene.set("front.direction", json(slanted));
    scene.add("interactor.light", "back", R"({"direction": )" + json(other) + R"(, "color": [0.2, 0.4, 0.9], "intensity": 0.5})");
    expect_closed_form(scene, {{.direction = slanted}, {.direction = other, .color = 0.5f * glm::vec3(0.2f, 0.4f, 0.9f)}}, highlight);
  }
}

TEST(Lighting, PointLightsFallOffAsTheySay) {
  const std::pair<const char*, std::function<float(float)>> falloffs[] = {
      {"none", [](float) { return 1.0f; }}, {"linear", [](float d) { return d; }}, {"quadratic", [](float d) { return d * d; }}};
  for (const auto& [name, falloff] : falloffs) {
    for (const auto& [type, highlight] : {std::pair<const char*, Highlight>("specular.blinn", halfway_term), std::pair<const char*, Highlight>("specular.phong", mirror_term)}) {
      Scene scene;
      add_ball(scene, type);
      const glm::vec3 place(1.5f, 1, 2);
      scene.set("front.kind", "point");
      scene.set("front.position", json(place));
      scene.set("front.falloff", name);
      expect_closed_form(scene, {{.position = place, .point = true, .falloff = falloff}}, highlight);
    }
  }
}

TEST(Lighting, DepthAndPositionAreWorldUnitsFromTheEye) {
  Scene scene({33, 33});
  scene.surface("wall", lumen::testing::moved(*lumen::testing::rectangle(), {0, 0, 0.25f}));
  EXPECT_NEAR(scene.layer("depth").at(16, 16), 9.75f, 1e-5f);
  EXPECT_TRUE(std::isinf(scene.layer("depth").at(0, 0)));
  const glm::vec3 corner = scene.layer("position").rgb(28, 4);
  EXPECT_NEAR(corner.x, 12 * 2.2f / 33, 1e-5f);
  EXPECT_NEAR(corner.y, 12 * 2.2f / 33, 1e-5f);
  EXPECT_NEAR(corner.z, 0.25f, 1e-5f);
}

TEST(Lighting, NormalsFaceTheEyeFromBehindToo) {
  Scene scene({17, 17});
  scene.surface("wall", lumen::testing::rectangle(), R"({"transform": [-1,0,0,0, 0,1,0,0, 0,0,-1,0, 0,0,0,1]})");
  EXPECT_NEAR(scene.layer("normal").at(8, 8, 2), 1, 1e-6f);
}

TEST(Lighting, IdNamesInstancePartAndPrimitive) {
  Scene scene({17, 17});
  scene.surface("wall", lumen::testing::rectangle());
  const Pixels id = scene.layer("id");
  EXPECT_GT(id.at(8, 8, 0), 0);
  EXPECT_EQ(id.at(8, 8, 1), 1);
  EXPECT_GE(id.at(8, 8, 2), 1);
  EXPECT_LE(id.at(8, 8, 2), 2);
  EXPECT_EQ(id.at(0, 0, 0), 0);
}

}  // namespace
