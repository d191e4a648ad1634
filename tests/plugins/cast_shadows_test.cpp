/// Cast shadows lie where geometry puts them, and nothing shades itself.
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <lumen/testing.h>

namespace {

using lumen::Value;
using lumen::testing::Pixels;
using lumen::testing::Scene;

/// A picture 4 world units high, 40 pixels each: the plane z = 0 seen from above, all white.
struct Plane {
  Scene scene{{160, 160}};
  explicit Plane(std::string_view shadows, float extent = 8) {
    scene.set("camera.height", "4");
    scene.add("ambient.constant", "ambient");
    scene.surface("plane", lumen::testing::rectangle(extent, extent), R"({"ambient": "ambient", "ambient_color": [1, 1, 1]})");
    scene.add("compositor.cast_shadows", "shadows", shadows);
  }
  void box() {
    scene.surface("box", lumen::testing::moved(*lumen::testing::box(glm::vec3(0.5f)), {0, 0, 1}), R"({"ambient": "ambient", "ambient_color": [1, 1, 1]})");
  }
  static float pixel(float world) { return 80 + world * 40; }
};

/// Where the values of a row or column first and last fall below `level`, to a part of a pixel.
glm::vec2 dark_between(const std::vector<float>& values, float level) {
  glm::vec2 found(NAN);
  for (std::size_t i = 1; i < values.size(); ++i) {
    const float crossing = float(i) - 0.5f + (values[i - 1] - level) / (values[i - 1] - values[i]);
    if (values[i - 1] >= level && values[i] < level && std::isnan(found.x)) found.x = crossing;
    if (values[i - 1] < level && values[i] >= level) found.y = crossing;
  }
  return found;
}

std::vector<float> row(const Pixels& picture, int y, int from, int to) {
  std::vector<float> values(std::size_t(from), 1.0f);
  for (int x = from; x < to; ++x) values.push_back(picture.at(x, y));
  return values;
}
std::vector<float> column(const Pixels& picture, int x) {
  std::vector<float> values;
  for (int y = 0; y < picture.height(); ++y) values.push_back(picture.at(x, y));
  return values;
}

TEST(CastShadows, ABoxsShadowInParallelLightIsItsProjection) {
  Plane plane(R"({"softness": 0, "strength": 1})");
  plane.box();
  plane.scene.set("front.direction", "[1, 0, 1]");
  const Pixels picture = plane.scene.picture();
  // The box spans x -0.25..0.25 and z 0.75..1.25; light at 45 degrees shifts by the height.
  const glm::vec2 x = dark_between(row(picture, 80, 0, 68), 0.5f), y = dark_between(column(picture, 40), 0.5f);
  EXPECT_NEAR(x.x, Plane::pixel(-1.5f), 1.5f);
  EXPECT_NEAR(x.y, Plane::pixel(-0.5f), 1.5f);
  EXPECT_NEAR(y.x, Plane::pixel(-0.25f), 1.5f);
  EXPECT_NEAR(y.y, Plane::pixel(0.25f), 1.5f);
  EXPECT_NEAR(picture.at(40, 80), 0, 1e-3f);
  EXPECT_EQ(picture.at(140, 80), 1);
  EXPECT_TRUE(plane.scene.problems().empty());
}

TEST(CastShadows, APointsShadowIsTheCentralProjection) {
  Plane plane(R"({"softness": 0, "strength": 0.75, "color": [0, 0, 0], "resolution": 2048})", 4);
  plane.box();
  plane.scene.set("front.kind", "point");
  plane.scene.set("front.position", "[2, 0, 6]");
  const Pixels picture = plane.scene.picture();
  const auto projected = [](float x, float z) { return 2 + (x - 2) * 6 / (6 - z); };
  const glm::vec2 x = dark_between(row(picture, 80, 0, 70), 0.625f);
  EXPECT_NEAR(x.x, Plane::pixel(projected(-0.25f, 1.25f)), 1.5f);
  const glm::vec2 y = dark_between(column(picture, 60), 0.625f);
  // The ray to x = -0.5 enters the box through its top, where the shadow's width comes from.
  const float half = 0.25f * 6 / (6 - 1.25f);
  EXPECT_NEAR(y.x, Plane::pixel(-half), 1.5f);
  EXPECT_NEAR(y.y, Plane::pixel(half), 1.5f);
  EXPECT_NEAR(picture.at(60, 80), 0.25f, 1e-3f);
  EXPECT_TRUE(plane.scene.problems().empty());
}

TEST(CastShadows, ASoftEdgeIsAsWideAsTheSoftnessSays) {
  Plane plane(R"({"softness": 0.05, "strength": 1, "samples": 64})");
  plane.box();
  plane.scene.set("front.direction", "[1, 0, 1]");
  const Pixels picture = plane.scene.picture();
  const float radius = 0.5f * std::sqrt(64 + 64 + 1.25f * 1.25f) * 0.05f;
  // Seen along the light the edge is foreshortened by the cosine of 45 degrees.
  const float reach = radius * std::sqrt(2.0f) * 40;
  const std::vector<float> values = row(picture, 80, 0, 60);
  const float edge = Plane::pixel(-1.5f);
  EXPECT_EQ(values[std::size_t(edge - reach - 3)], 1);
  EXPECT_LT(values[std::size_t(edge - 0.6f * reach)], 0.99f);
  EXPECT_GT(values[std::size_t(edge - 0.6f * reach)], 0.6f);
  EXPECT_NEAR(dark_between(values, 0.5f).x, edge, 2.5f);
}

TEST(CastShadows, TiltedPlanesDoNotShadeThemselves) {
  const Scene shared;  // the driver's context stays from scene to scene
  for (const char* direction : {"[0, 0, 1]", "[1, 0, 1]", "[3, 2, 1]", "[-4, 1, 1]"}) {
    for (const char* softness : {"0", "0.1"}) {
      Plane plane(R"({"strength": 1, "resolution": 256})");
      plane.scene.set_value("plane.transform", Value(glm::rotate(glm::mat4(1), 0.3f, glm::vec3(1, 0.5f, 0))));
      plane.scene.set("front.direction", direction);
      plane.scene.set("shadows.softness", softness);
      const Pixels picture = plane.scene.picture();
      const glm::vec3 normal = glm::mat3(glm::rotate(glm::mat4(1), 0.3f, glm::vec3(1, 0.5f, 0))) * glm::vec3(0, 0, 1);
      const auto parts = std::get<glm::vec3>(plane.scene.value("front.direction"));
      if (glm::dot(normal, glm::normalize(parts)) < 0.16f) continue;
      for (int y = 0; y < 160; ++y)
        for (int x = 0; x < 160; ++x) ASSERT_EQ(picture.at(x, y), 1) << direction << " " << softness << " at " << x << " " << y;
    }
  }
}

TEST(CastShadows, ASpheresLitSideIsLitAndItsOtherSideDark) {
  const Scene shared;
  for (const char* kind : {"directional", "point"}) {
    Scene scene({128, 128});
    scene.add("ambient.constant", "ambient");
    scene.surface("ball", lumen::testing::sphere(128), R"({"ambient": "ambient", "ambient_color": [1, 1, 1]})");
    scene.set("front.kind", kind);
    scene.set("front.direction", "[1, 0, 0]");
    scene.set("front.position", "[20, 0, 0]");
    scene.add("compositor.cast_shadows", "shadows", R"({"strength": 1, "softness": 0.02})");
    const Pixels normal = scene.layer("normal"), picture = scene.picture();
    for (int y = 0; y < 128; ++y)
      for (int x = 0; x < 128; ++x) {
        if (normal.rgb(x, y) == glm::vec3(0)) continue;
        if (normal.at(x, y) > 0.22f) { EXPECT_EQ(picture.at(x, y), 1) << kind << x << " " << y; }
        if (normal.at(x, y) < -0.06f) { EXPECT_EQ(picture.at(x, y), 0) << kind << x << " " << y; }
      }
  }
}

TEST(CastShadows, ALightBehindReachesNothing) {
  Plane plane(R"({"strength": 0.5, "color": [1, 0, 0]})");
  plane.scene.set("front.direction", "[0, 0.1, -1]");
  const Pixels picture = plane.scene.picture();
  EXPECT_EQ(picture.rgba(80, 80), glm::vec4(1, 0.5f, 0.5f, 1));
}

TEST(CastShadows, ALightThatIsNotThereIsSaid) {
  Plane plane(R"({"light": 3})");
  EXPECT_EQ(plane.scene.picture().rgba(80, 80), glm::vec4(1));
  ASSERT_EQ(plane.scene.problems().size(), 1u);
  EXPECT_EQ(plane.scene.problems().front().instance, "shadows");
}

TEST(CastShadows, AMovedLightMovesTheShadow) {
  Plane plane(R"({"softness": 0, "strength": 1})");
  plane.box();
  plane.scene.set("front.direction", "[1, 0, 1]");
  EXPECT_LT(plane.scene.picture().at(40, 80), 0.5f);
  plane.scene.set("front.direction", "[-1, 0, 1]");
  EXPECT_EQ(plane.scene.picture().at(40, 80), 1);
  EXPECT_LT(plane.scene.picture().at(120, 80), 0.5f);
  plane.scene.set_value("box.transform", Value(glm::translate(glm::mat4(1), glm::vec3(-2, 0, 0))));
  EXPECT_EQ(plane.scene.picture().at(120, 80), 1);
}

}  // namespace
