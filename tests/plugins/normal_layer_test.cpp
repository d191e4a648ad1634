/// Layer normal: unit, facing the eye, on the side of its triangle.
#include <cmath>

#include <gtest/gtest.h>
#include <lumen/testing.h>

namespace {

using lumen::testing::Pixels;
using lumen::testing::Scene;

TEST(NormalLayer, LeansOverTheSilhouetteInsteadOfTurningInward) {
  Scene scene({128, 128});
  // Turned by 5 degrees, so that faces at the silhouette have corners whose averaged normals face away.
  scene.surface("ball", lumen::testing::sphere(10), R"({"transform": [0.9962,0,0.0872,0, 0,1,0,0, -0.0872,0,0.9962,0, 0,0,0,1]})");
  const Pixels normal = scene.layer("normal");
  int leaning = 0;
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 128; ++x) {
      const glm::vec3 n = normal.rgb(x, y);
      if (n == glm::vec3(0)) continue;
      EXPECT_NEAR(glm::length(n), 1.0f, 1e-5f);
      EXPECT_GE(n.z, -1e-6f);
      const glm::vec2 outward(float(x) - 63.5f, 63.5f - float(y));
      if (glm::length(outward) > 8) { EXPECT_GT(n.x * outward.x + n.y * outward.y, 0) << x << ", " << y; }
      leaning += n.z < 1e-4f ? 1 : 0;
    }
  EXPECT_GT(leaning, 0) << "no pixel shows what this is about";
}

TEST(NormalLayer, FacesTheEyeOnBothSidesOfAnOpenSurface) {
  Scene scene({32, 32});
  scene.surface("sheet", lumen::testing::rectangle(), R"({"transform": [-1,0,0,0, 0,1,0,0, 0,0,-1,0, 0,0,0,1]})");
  EXPECT_NEAR(scene.layer("normal").at(16, 16, 2), 1.0f, 1e-6f);
}

}  // namespace
