/// Opacities by contours and highlights against closed forms, through the program's own path.
#include "plugins/term_oracle.h"

namespace lumen::testing {
namespace {

/// The opacity of one layer, where a closed surface shows two that are alike.
float of_two(float both) { return 1 - std::sqrt(std::max(0.0f, 1 - both)); }

TEST(GlassOpacity, IsTheEdgeOrTheHighlightsOfAllLights) {
  Scene scene({64, 64});
  scene.surface("sheet", [] {
    // The front half of a sphere, so that a pixel shows one layer; the closed form needs no more than its normals.
    auto half = std::make_shared<Mesh>();
    const auto whole = sphere(128);
    std::vector<glm::uvec3> triangles;
    for (const glm::uvec3& t : whole->triangles)
      if (whole->positions[t.x].z > -0.01f && whole->positions[t.y].z > -0.01f && whole->positions[t.z].z > -0.01f) triangles.push_back(t);
    half->positions = whole->positions;
    half->normals = whole->normals;
    half->triangles = std::move(triangles);
    half->finish();
    return half;
  }(), R"({"opacity": "glass"})");
  scene.add("opacity.glass", "glass", R"({"falloff": 0.5, "alpha_min": 0.1, "alpha_max": 0.6, "highlights": 0.7, "shininess": 30})");
  scene.add("transparency.weighted", "weighted");
  const glm::vec3 other = glm::normalize(glm::vec3(-0.5f, -0.3f, 0.4f));
  scene.set("front.direction", json(slanted));
  scene.add("interactor.light", "back", R"({"direction": )" + json(other) + R"(, "color": [0.2, 0.9, 0.4], "intensity": 2})");
  const Pixels opacity = scene.layer("opacity");
  int highlights = 0, covered = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const glm::vec2 at((float(x) - 31.5f) * 2.2f / 64, (31.5f - float(y)) * 2.2f / 64);
      if (glm::dot(at, at) > 0.95f) continue;
      const glm::vec3 n(at, std::sqrt(1 - glm::dot(at, at))), v(0, 0, 1);
      const auto lobe = [&](glm::vec3 l) { return glm::dot(n, l) > 0 ? std::pow(std::max(0.0f, glm::dot(n, glm::normalize(l + v))), 30.0f) : 0.0f; };
      const glm::vec3 light = lobe(slanted) * glm::vec3(1) + 2 * lobe(other) * glm::vec3(0.2f, 0.9f, 0.4f);
      const float highlight = 0.7f * std::max(light.x, std::max(light.y, light.z)), edge = 0.1f + 0.5f * (1 - std::sqrt(n.z));
      ASSERT_NEAR(opacity.at(x, y), std::min(1.0f, std::max(edge, highlight)), 6e-3f) << x << ", " << y;
      highlights += highlight > edge;
      ++covered;
    }
  EXPECT_GT(highlights, 50);
  EXPECT_GT(covered, 1500);
  EXPECT_TRUE(scene.problems().empty());
}

TEST(GlassOpacity, WithoutHighlightsIsFresnel) {
  const auto draw = [](const char* type, const char* properties) {
    Scene scene({48, 48});
    scene.surface("ball", sphere(96), R"({"opacity": "term"})");
    scene.add(type, "term", properties);
    scene.add("transparency.weighted", "weighted");
    return scene.layer("opacity");
  };
  EXPECT_LT(largest_difference(draw("opacity.glass", R"({"highlights": 0, "falloff": 0.3, "alpha_max": 1})"), draw("opacity.fresnel", R"({"falloff": 0.3})")), 1e-6f);
}

void add_contours(Scene& scene, const std::string& properties) {
  scene.add("opacity.contours", "term", properties);
  scene.add("transparency.weighted", "weighted");
}

TEST(ContourOpacity, ContoursAreAsWideAsTheySay) {
  for (const float radius : {1.0f, 0.5f}) {
    for (const int thickness : {2, 6}) {
      Scene scene({220, 220});  // 100 pixels per unit
      scene.surface("ball", sphere(256, radius), R"({"opacity": "term"})");
      add_contours(scene, R"({"alpha_min": 0, "thickness": )" + std::to_string(thickness) + "}");
      const Pixels opacity = scene.layer("opacity");
      for (const int row : {110, 90}) {
        for (int x = 0; x < 110; ++x) {
          const float from_center = std::sqrt(float((x - 109.5f) * (x - 109.5f)) + float((row - 109.5f) * (row - 109.5f)));
          const float away = 100 * radius - from_center;
          const bool outside = away < -0.7f, inside = away > float(thickness) + 1, drawn = away > 0.7f && away < float(thickness) - 1;
          if (drawn) {
            EXPECT_GT(opacity.at(x, row), 0.99f) << x << ", " << row;
          } else if (outside || inside) {
            EXPECT_EQ(opacity.at(x, row), 0) << x << ", " << row << ": a ball has no suggestive contour";
          }
        }
      }
    }
  }
}

TEST(ContourOpacity, ContoursKeepTheirWidthInPerspective) {
  Scene scene({200, 200});
  scene.surface("ball", sphere(256), R"({"opacity": "term"})");
  add_contours(scene, R"({"alpha_min": 0, "thickness": 5})");
  look_from_near(scene, 4);
  const Pixels opacity = scene.layer("opacity");
  float width = 0;
  for (int x = 0; x < 100; ++x) width += of_two(opacity.at(x, 100));
  EXPECT_NEAR(width, 5.5f, 1);
}

/// A corrugated sheet, z = height cos(frequency x), whose radial curvature seen along -z is that of its section.
std::shared_ptr<Mesh> corrugated(float height, float frequency) {
  auto mesh = std::make_shared<Mesh>();
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::uvec3> triangles;
  constexpr std::uint32_t steps = 800;
  for (std::uint32_t i = 0; i <= steps; ++i) {
    const float x = 2.4f * float(i) / steps - 1.2f, slope = -height * frequency * std::sin(frequency * x);
    for (const float y : {-1.2f, 1.2f}) {
      positions.emplace_back(x, y, height * std::cos(frequency * x));
      normals.push_back(glm::normalize(glm::vec3(-slope, 0, 1)));
    }
    if (i == steps) break;
    triangles.emplace_back(2 * i, 2 * i + 2, 2 * i + 3);
    triangles.emplace_back(2 * i, 2 * i + 3, 2 * i + 1);
  }
  mesh->positions = std::move(positions);
  mesh->normals = std::move(normals);
  mesh->triangles = std::move(triangles);
  mesh->finish();
  return mesh;
}

TEST(ContourOpacity, SuggestiveContoursLieWhereTheSurfaceBendsIn) {
  constexpr float height = 0.1f, frequency = 8;
  Scene scene({160, 20});
  const auto mesh = corrugated(height, frequency);
  scene.surface("sheet", mesh, R"({"opacity": "term"})");
  scene.set("camera.height", "0.275");  // 2.2 wide
  add_contours(scene, R"({"alpha_min": 0.1, "alpha_max": 0.9, "thickness": 0, "suggestive": 0.5, "cut_off": 2, "angle": 12})");
  const Pixels opacity = scene.layer("opacity");
  const auto rise = [](float from, float to, float x) {
    const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
  };
  int drawn = 0, clear = 0;
  for (int x = 0; x < 160; ++x) {
    const float at = (float(x) - 79.5f) * 2.2f / 160;
    const float slope = -height * frequency * std::sin(frequency * at), bend = -height * frequency * frequency * std::cos(frequency * at);
    const float curvature = -bend / std::pow(1 + slope * slope, 1.5f) * mesh->bounds().radius();
    const float wanted = 0.1f + 0.8f * 0.5f * rise(1, 2, -curvature / 2) * rise(12, 22, glm::degrees(std::atan(std::abs(slope))));
    EXPECT_NEAR(opacity.at(x, 10), wanted, 0.02f) << "x = " << at;
    drawn += wanted > 0.45f;
    clear += wanted < 0.11f;
  }
  EXPECT_GT(drawn, 15);
  EXPECT_GT(clear, 60);
}

TEST(ContourOpacity, BackFacesHaveNoSuggestiveContours) {
  const auto mean = [](const char* transform) {
    Scene scene({80, 10});
    scene.surface("sheet", corrugated(0.1f, 8), std::string(R"({"opacity": "term", "transform": )") + transform + "}");
    scene.set("camera.height", "0.275");
    add_contours(scene, R"({"alpha_min": 0, "thickness": 0, "cut_off": 2, "angle": 12})");
    const Pixels opacity = scene.layer("opacity");
    double sum = 0;
    for (int x = 0; x < 80; ++x) sum += opacity.at(x, 5);
    return sum / 80;
  };
  EXPECT_GT(mean("[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]"), 0.1);
  EXPECT_EQ(mean("[-1,0,0,0, 0,1,0,0, 0,0,-1,0, 0,0,0,1]"), 0);
}

TEST(ContourOpacity, FlatFacesAreClear) {
  Scene scene({64, 64});
  scene.surface("box", box(glm::vec3(1)), R"({"opacity": "term", "transform": [0.8,0,-0.6,0, 0.3,0.866,0.4,0, 0.52,-0.5,0.693,0, 0,0,0,1]})");
  add_contours(scene, R"({"alpha_min": 0.2})");
  const Pixels opacity = scene.layer("opacity");
  int covered = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      if (opacity.at(x, y) == 0) continue;
      EXPECT_NEAR(of_two(opacity.at(x, y)), 0.2f, 1e-5f) << x << ", " << y;
      ++covered;
    }
  EXPECT_GT(covered, 500);
}

}  // namespace
}  // namespace lumen::testing
