/// transparency.weighted and the opacities: exact where they must be, whatever the order.

#include <cmath>

#include <gtest/gtest.h>
#include <lumen/testing.h>

namespace {

using lumen::testing::Pixels;
using lumen::testing::Scene;

/// A rectangle at z that shows `color` as it is: ambient light alone.
void add_sheet(Scene& scene, const std::string& id, float z, const std::string& color, const std::string& opacity) {
  scene.surface(id, lumen::testing::moved(*lumen::testing::rectangle(), {0, 0, z}),
                R"({"ambient": "ambient", "opacity": ")" + opacity + R"(", "ambient_color": )" + color + "}");
}

void add_terms(Scene& scene, const std::string& alpha) {
  scene.add("ambient.constant", "ambient");
  scene.add("opacity.constant", "alpha", R"({"alpha": )" + alpha + "}");
  scene.add("transparency.weighted", "weighted");
}

void expect_color(const Pixels& pixels, glm::vec3 wanted, float tolerance = 1e-5f) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(pixels.at(16, 16, c), wanted[c], tolerance) << "channel " << c;
}

TEST(WeightedTransparency, OneLayerIsExactOverTheOpaqueScene) {
  for (const char* weight : {"normalized", "none", "eq7", "eq8", "eq9", "eq10"}) {
    Scene scene({33, 33});
    add_terms(scene, "0.3");
    scene.set("weighted.weight", weight);
    scene.surface("behind", lumen::testing::rectangle(), R"({"ambient": "ambient", "ambient_color": [0, 1, 0]})");
    add_sheet(scene, "sheet", 0.5f, "[1, 0, 0.5]", "alpha");
    expect_color(scene.layer("color"), {0.3f, 0.7f, 0.15f});
    EXPECT_NEAR(scene.layer("opacity").at(16, 16), 0.3f, 1e-6f) << weight;
  }
}

TEST(WeightedTransparency, EqualColorsAreExactAndRevealageIsTheProduct) {
  Scene scene({33, 33});
  add_terms(scene, "0.3");
  for (int i = 0; i < 5; ++i) add_sheet(scene, "sheet" + std::to_string(i), 0.1f * float(i), "[0.8, 0.4, 0.2]", "alpha");
  const float opacity = 1 - std::pow(0.7f, 5.0f);
  expect_color(scene.layer("transparent"), opacity * glm::vec3(0.8f, 0.4f, 0.2f));
  EXPECT_NEAR(scene.layer("opacity").at(16, 16), opacity, 1e-6f);
}

TEST(WeightedTransparency, OrderOfDrawingDoesNotMatter) {
  const char* colors[] = {"[1, 0, 0]", "[0, 1, 0]", "[0, 0, 1]", "[1, 1, 0]"};
  const auto draw = [&](std::vector<int> order) {
    Scene scene({33, 33});
    add_terms(scene, "0.4");
    for (const int i : order) add_sheet(scene, "sheet" + std::to_string(i), 0.2f * float(i), colors[i], "alpha");
    return scene.layer("color");
  };
  EXPECT_LT(lumen::testing::largest_difference(draw({0, 1, 2, 3}), draw({3, 1, 0, 2})), 1e-5f);
}

TEST(WeightedTransparency, SwappingTwoLayersShowsInTheNormalizedPicture) {
  for (const auto& [near, far] : {std::pair(10.0f, 20.0f), std::pair(300.0f, 320.0f)}) {
    const auto draw = [&](const char* first, const char* second) {
      Scene scene({33, 33});
      add_terms(scene, "0.5");
      scene.set("camera.distance", std::to_string(near));
      add_sheet(scene, "near_sheet", 0, first, "alpha");
      add_sheet(scene, "far_sheet", near - far, second, "alpha");
      return scene.layer("color");
    };
    EXPECT_GT(lumen::testing::largest_difference(draw("[1, 0, 0]", "[0, 0, 1]"), draw("[0, 0, 1]", "[1, 0, 0]")), 5.0f / 255);
  }
}

TEST(WeightedTransparency, OpaqueSurfacesHideWhatIsBehindThem) {
  Scene scene({33, 33});
  add_terms(scene, "0.5");
  scene.surface("wall", lumen::testing::moved(*lumen::testing::rectangle(), {0, 0, 0.5f}), R"({"ambient": "ambient", "ambient_color": [0, 1, 0]})");
  add_sheet(scene, "sheet", 0, "[1, 0, 0]", "alpha");
  expect_color(scene.layer("color"), {0, 1, 0});
  EXPECT_EQ(scene.layer("opacity").at(16, 16), 0);
}

TEST(FresnelOpacity, IsTheClosedFormAndItsMeanOverASphereIsFOverFPlusTwo) {
  for (const float falloff : {0.25f, 1.0f, 3.0f}) {
    Scene scene({128, 128});
    scene.add("ambient.constant", "ambient");
    scene.add("opacity.fresnel", "fresnel", R"({"falloff": )" + std::to_string(falloff) + "}");
    scene.add("transparency.weighted", "weighted");
    scene.surface("ball", lumen::testing::sphere(256), R"({"ambient": "ambient", "opacity": "fresnel"})");
    const Pixels opacity = scene.layer("opacity");
    double sum = 0;
    int covered = 0;
    for (int y = 0; y < 128; ++y) {
      for (int x = 0; x < 128; ++x) {
        const glm::vec2 at((float(x) + 0.5f - 64) * 2.2f / 128, (64 - float(y) - 0.5f) * 2.2f / 128);
        const float square = glm::dot(at, at);
        if (square >= 0.98f) continue;
        const float one = 1 - std::pow(std::sqrt(1 - square), falloff);
        const float both = 1 - (1 - one) * (1 - one);  // front and back of the sphere have the same angle
        EXPECT_NEAR(opacity.at(x, y), both, 0.012f) << x << ", " << y;
        sum += 1 - std::sqrt(std::max(0.0f, 1 - opacity.at(x, y)));
        ++covered;
      }
    }
    // The mean over r^2 < .98, as the closed form of the same disk.
    const float cut = std::pow(0.02f, falloff / 2 + 1);
    const float wanted = 1 - (1 - cut) / (falloff / 2 + 1) / 0.98f;
    EXPECT_NEAR(sum / covered, wanted, 0.01) << "falloff " << falloff;
  }
}

}  // namespace
