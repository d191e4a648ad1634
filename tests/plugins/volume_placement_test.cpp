/// splitter.volume placed by interest: as good as the best of a grid, by a worth that the test computes itself.

#include <cmath>

#include <gtest/gtest.h>
#include <lumen/testing.h>

namespace {

using lumen::testing::Pixels;
using lumen::testing::Scene;

constexpr int side = 96;
constexpr float ball = 0.3f, ball_x = 0.35f, alpha = 2, beta = 1.5f;

/// A plate at z = 0.6 before a ball, off the middle.
void add_plate_and_ball(Scene& scene, const char* volume) {
  scene.add("diffuse.lambert", "lambert");
  scene.add("splitter.volume", "volume", volume);
  scene.surface("plate", lumen::testing::moved(*lumen::testing::rectangle(), {0, 0, 0.6f}), R"({"diffuse": "lambert", "splitter": "volume"})");
  scene.surface("ball", lumen::testing::moved(*lumen::testing::sphere(128, ball), {ball_x, 0, 0}), R"({"diffuse": "lambert"})");
}

/// Where the ball is in the picture.
std::vector<glm::vec2> ball_places() {
  std::vector<glm::vec2> places;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const glm::vec2 at = (glm::vec2(x, y) + 0.5f) * (2.2f / side) - 1.1f;
      if (glm::distance(at, glm::vec2(ball_x, 0)) <= ball) places.push_back(at);
    }
  return places;
}

/// Eq. 2.1 over these: a sphere opens a disk in the plate.
float worth(const std::vector<glm::vec2>& places, glm::vec3 center, float radius, float scene_radius) {
  const float squared = radius * radius - (center.z - 0.6f) * (center.z - 0.6f);
  const auto all = int(places.size());
  int hidden = 0;
  for (const glm::vec2 at : places) hidden += glm::dot(at - glm::vec2(center), at - glm::vec2(center)) > squared;
  return (alpha * float(all - hidden) - float(hidden)) / float(all) - beta * std::pow(radius / scene_radius, 3.0f);
}

TEST(VolumePlacement, IsAsGoodAsTheBestOfAGrid) {
  Scene scene({side, side});
  add_plate_and_ball(scene, R"({"place": "by_interest", "interest": ["ball"], "alpha": 2, "beta": 1.5})");
  scene.layer("depth");
  const glm::vec3 center = std::get<glm::vec3>(scene.value("volume.center"));
  const float radius = std::get<float>(scene.value("volume.radius"));
  // The scene's box is 2 x 2 x 0.9.
  const float scene_radius = std::sqrt(1 + 1 + 0.2025f);
  const std::vector<glm::vec2> places = ball_places();
  float best = -1e9f;
  for (float x = -0.2f; x < 0.8f; x += 0.05f)
    for (float y = -0.2f; y < 0.21f; y += 0.05f)
      for (float z = 0.4f; z < 0.81f; z += 0.05f)
        for (float r = 0.1f; r < 0.8f; r += 0.02f) best = std::max(best, worth(places, {x, y, z}, r, scene_radius));
  EXPECT_GE(worth(places, center, radius, scene_radius), best - 0.05f * std::abs(best)) << center.x << " " << center.y << " " << center.z << ", radius " << radius;
  EXPECT_GT(best, 1.5f);
}

TEST(VolumePlacement, UncoversWhatIsOfInterest) {
  for (const char* shape : {"sphere", "box", "tube"}) {
    Scene scene({side, side});
    add_plate_and_ball(scene, R"({"place": "by_interest", "interest": ["ball"]})");
    scene.set("volume.shape", shape);
    const Pixels depth = scene.layer("depth");
    int hidden = 0, seen = 0;
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const float off = std::hypot((float(x) + 0.5f) * 2.2f / side - 1.1f - ball_x, (float(y) + 0.5f) * 2.2f / side - 1.1f);
        if (off < ball - 0.02f) (depth.at(x, y) < 9.5f ? hidden : seen) += 1;
      }
    EXPECT_LE(hidden, (hidden + seen) / 20) << shape;
    EXPECT_FALSE(std::isinf(depth.at(10, 10))) << shape << ": the rest of the plate stays";
  }
}

TEST(VolumePlacement, WhatIsSetStaysAndNothingHiddenMeansNoCut) {
  Scene scene({side, side});
  add_plate_and_ball(scene, R"({"place": "by_interest", "interest": ["ball"], "center": [0, 0, 0.6]})");
  scene.layer("depth");
  EXPECT_EQ(std::get<glm::vec3>(scene.value("volume.center")), glm::vec3(0, 0, 0.6f));
  EXPECT_NEAR(std::get<float>(scene.value("volume.radius")), ball + ball_x, 0.06f) << "from there, it must reach the ball's far rim";
  scene.set("plate.transform", "[1,0,0,0, 0,1,0,0, 0,0,1,-2, 0,0,0,1]");
  scene.layer("depth");
  EXPECT_EQ(std::get<float>(scene.value("volume.radius")), 0);
}

}  // namespace
