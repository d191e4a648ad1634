/// opacity.ghost against its closed form.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <lumen/testing.h>

namespace {

using lumen::testing::Pixels;
using lumen::testing::Scene;

void add_ghost(Scene& scene, std::shared_ptr<const lumen::Mesh> mesh, const char* properties) {
  scene.add("opacity.ghost", "ghost", properties);
  scene.add("transparency.weighted", "weighted");
  scene.surface("shown", std::move(mesh), R"({"opacity": "ghost"})");
}

TEST(GhostOpacity, FadesAboutItsCenter) {
  Scene scene({110, 110});  // 50 pixels per world unit
  add_ghost(scene, lumen::testing::rectangle(), R"({"center": [0.2, 0, 0], "radius": 0.3, "softness": 0.5, "faintest": 0.1, "background": 0.8})");
  const Pixels opacity = scene.layer("opacity");
  const float radius = 0.3f * std::sqrt(2.0f), soft = 0.5f * radius;  // the scene's radius is that of the plate's corners
  for (int y = 6; y < 104; ++y)
    for (int x = 6; x < 104; ++x) {
      const float away = std::hypot((float(x) - 54.5f) / 50 - 0.2f, (float(y) - 54.5f) / 50);
      const float t = std::clamp((away - radius + soft) / (2 * soft), 0.0f, 1.0f), membership = 1 - t * t * (3 - 2 * t);
      ASSERT_NEAR(opacity.at(x, y), 0.8f - 0.7f * membership, 1e-3f) << x << ", " << y;
    }
}

TEST(GhostOpacity, KeepsSilhouettes) {
  Scene scene({110, 110});
  add_ghost(scene, lumen::testing::sphere(256), R"({"radius": 4, "faintest": 0.1, "features": 0.7, "sharpness": 2})");
  const Pixels opacity = scene.layer("opacity");
  for (int x = 55; x < 103; ++x) {
    const float off = (float(x) - 54.5f) / 50, facing = std::sqrt(1 - off * off - 1e-4f), edge = (1 - facing) * (1 - facing);
    const float alpha = 0.1f + 0.6f * edge;
    ASSERT_NEAR(opacity.at(x, 54), 1 - (1 - alpha) * (1 - alpha), 0.01f) << "the front and the back, at " << off;
  }
}

}  // namespace
