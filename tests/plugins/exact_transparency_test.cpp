/// transparency.linked_list and transparency.peel against sorted compositing on the CPU.

#include <gtest/gtest.h>

#include "transparent_sheets.h"

namespace {

using sheets::Layer;
using sheets::Pixels;
using sheets::Scene;
using sheets::Sheet;

constexpr float exact = 1e-4f;

class ExactTransparency : public testing::TestWithParam<const char*> {
 protected:
  /// Peels for all layers of the tests; the other technique has no such bound.
  void add_technique(Scene& scene) {
    scene.add(GetParam(), "technique");
    if (GetParam() == std::string_view("transparency.peel")) scene.set("technique.peels", "33");
  }
};
INSTANTIATE_TEST_SUITE_P(, ExactTransparency, testing::Values("transparency.linked_list", "transparency.peel"), [](const auto& info) {
  return std::string(info.param).substr(std::string_view("transparency.").size());
});

TEST_P(ExactTransparency, IsSortedCompositingOfShuffledSheets) {
  for (const int count : {2, 3, 8, 9, 17, 64}) {
    const auto list = sheets::shuffled(count, unsigned(count), count > 20 ? 0.1f : 0.9f);
    Scene scene({9, 9});
    add_technique(scene);
    sheets::add(scene, list);
    EXPECT_LT(sheets::largest_error(scene, list), exact) << count << " layers";
    EXPECT_TRUE(scene.problems().empty()) << count << " layers";
  }
}

TEST_P(ExactTransparency, LiesOverTheOpaqueSceneAndIsHiddenByIt) {
  const auto list = sheets::shuffled(6, 1);
  Scene scene({9, 9});
  add_technique(scene);
  sheets::add(scene, list);
  scene.surface("wall", lumen::testing::moved(*lumen::testing::rectangle(3, 3), {0, 0, -0.2f}), R"({"ambient": "ambient", "ambient_color": [0.2, 0.4, 0.6]})");
  std::vector<Layer> layers = {{-0.2f, {0.2f, 0.4f, 0.6f}, 1}};
  for (const Sheet& sheet : list) layers.push_back({sheet.height, sheet.color, sheet.alpha});
  const glm::vec4 wanted = sheets::composited(layers);
  const Pixels color = scene.layer("color");
  for (int c = 0; c < 4; ++c) EXPECT_NEAR(color.at(4, 4, c), wanted[c], exact);
}

TEST_P(ExactTransparency, SortsEachPixelOfIntersectingSheets) {
  const std::vector<Sheet> list = {{0, {1, 0, 0}, 0.5f, {0.9f, 0.01f}}, {0.003f, {0, 1, 0}, 0.4f, {-0.7f, 0.3f}}, {0.1f, {0, 0, 1}, 0.6f, {0, -0.8f}}, {-0.1f, {1, 1, 0}, 0.3f, {0.2f, 0.5f}}};
  Scene scene({48, 48});
  add_technique(scene);
  sheets::add(scene, list);
  EXPECT_LT(sheets::largest_error(scene, list), exact);
}

/// Depths of all crossings of a ray along -z with a mesh, and which surface it is.
void cast(const lumen::Mesh& mesh, glm::dvec2 at, glm::vec3 color, float alpha, std::vector<Layer>& layers) {
  for (const glm::uvec3 t : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    const auto side = [&](const glm::dvec3& p, const glm::dvec3& q) { return (q.x - p.x) * (at.y - p.y) - (q.y - p.y) * (at.x - p.x); };
    const double u = side(b, c), v = side(c, a), w = side(a, b), sum = u + v + w;
    if (sum == 0 || u * sum < 0 || v * sum < 0 || w * sum < 0) continue;
    layers.push_back({float((u * a.z + v * b.z + w * c.z) / sum), color, alpha});
  }
}

TEST_P(ExactTransparency, SortsASphereInsideASphereWhereTheOrderDiffersPerPixel) {
  const auto outer = lumen::testing::sphere(24, 0.8f), inner = lumen::testing::moved(*lumen::testing::sphere(24, 0.6f), {0.3f, 0.05f, 0.3f});
  Scene scene({48, 48});
  add_technique(scene);
  scene.add("ambient.constant", "ambient");
  scene.add("opacity.constant", "alpha", R"({"alpha": 0.4})");
  scene.surface("outer", outer, R"({"ambient": "ambient", "opacity": "alpha", "ambient_color": [1, 0.5, 0]})");
  scene.surface("inner", inner, R"({"ambient": "ambient", "opacity": "alpha", "ambient_color": [0, 0.5, 1]})");
  const Pixels pixels = scene.layer("transparent");
  int compared = 0, outer_first = 0;
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 48; ++x) {
      // Only where a 50th of a pixel, the rasterizer's precision, changes nothing.
      std::vector<glm::vec4> near;
      std::vector<Layer> layers;
      for (const glm::dvec2 offset : {glm::dvec2(0), glm::dvec2(1, 0), glm::dvec2(-1, 0), glm::dvec2(0, 1), glm::dvec2(0, -1)}) {
        layers.clear();
        const glm::dvec2 at = glm::dvec2(sheets::place_of(pixels, x, y)) + offset * (2.2 / 48 / 50);
        cast(*outer, at, {1, 0.5f, 0}, 0.4f, layers);
        cast(*inner, at, {0, 0.5f, 1}, 0.4f, layers);
        near.push_back(sheets::composited(layers));
      }
      if (std::any_of(near.begin(), near.end(), [&](const glm::vec4& n) { return glm::distance(n, near[0]) > 1e-6f; })) continue;
      for (int c = 0; c < 4; ++c) ASSERT_NEAR(pixels.at(x, y, c), near[0][c], exact) << x << ", " << y;
      compared += near[0].a > 0;
      outer_first += near[0].r > near[0].b;
    }
  EXPECT_GT(compared, 700);
  EXPECT_GT(outer_first, 100);
  EXPECT_LT(outer_first, compared - 100);
}

TEST_P(ExactTransparency, IsExactInPerspectiveToo) {
  const auto list = sheets::shuffled(9, 3);
  Scene scene({9, 9});
  add_technique(scene);
  sheets::add(scene, list);
  scene.set("camera.projection", "perspective");
  scene.set("camera.distance", "4");
  scene.set("camera.field_of_view", "20");
  const Pixels pixels = scene.layer("transparent");
  const glm::vec4 wanted = sheets::expected_at(list, {0, 0});
  for (int c = 0; c < 4; ++c) EXPECT_NEAR(pixels.at(4, 4, c), wanted[c], exact);
}

TEST_P(ExactTransparency, EqualDepthsComeOutTheSameEveryTime) {
  const std::vector<Sheet> list = {{0, {1, 0, 0}, 0.5f}, {0, {0, 1, 0}, 0.5f}, {0, {0, 0, 1}, 0.5f}, {-0.5f, {1, 1, 0}, 0.5f}};
  const auto draw = [&] {
    Scene scene({33, 33});
    add_technique(scene);
    sheets::add(scene, list);
    return scene.layer("transparent");
  };
  const Pixels first = draw();
  EXPECT_EQ(lumen::testing::largest_difference(first, draw()), 0);
  for (int c = 0; c < 4; ++c) EXPECT_EQ(first.at(3, 5, c), first.at(29, 20, c)) << "all pixels alike";
  EXPECT_NEAR(first.at(16, 16, 3), 1 - std::pow(0.5f, 4.0f), exact);
}

TEST(LinkedList, BreaksTiesBySurface) {
  const std::vector<Sheet> list = {{0, {1, 0, 0}, 0.5f}, {0, {0, 1, 0}, 0.5f}, {0, {0, 0, 1}, 0.5f}};
  Scene scene({9, 9});
  scene.add("transparency.linked_list", "technique");
  sheets::add(scene, list);
  EXPECT_LT(sheets::largest_error(scene, list), exact);
  scene.set("main.renderers", R"(["sheet2", "sheet0", "sheet1"])");
  EXPECT_LT(sheets::largest_error(scene, list), exact) << "drawn in another order";
}

TEST(LinkedList, CountsWhatFindsNoRoomAndSaysWhatToRaise) {
  Scene scene({128, 128});
  scene.add("transparency.linked_list", "technique", R"({"memory": 1})");
  const auto list = sheets::shuffled(8, 5, 0.5f);
  sheets::add(scene, list);
  const Pixels pixels = scene.layer("transparent");
  const auto problems = scene.problems();
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].severity, lumen::Severity::warning);
  // 8 x 128 x 128 fragments; 1 MB holds 50000 of 20 bytes.
  EXPECT_NE(problems[0].message.find("81072 of 131072 transparent fragments found no room"), std::string::npos) << problems[0].message;
  EXPECT_NE(problems[0].message.find("raise memory to 3 MB"), std::string::npos) << problems[0].message;
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 128; ++x)
      for (int c = 0; c < 4; ++c) {
        ASSERT_GE(pixels.at(x, y, c), 0.0f);
        ASSERT_LE(pixels.at(x, y, c), 1.0f + exact);
      }
  scene.set("technique.memory", "3");
  EXPECT_LT(sheets::largest_error(scene, list), exact);
  EXPECT_TRUE(scene.problems().empty());
}

TEST(LinkedList, KeepsBrightAndFaintColors) {
  Scene scene({9, 9});
  scene.add("transparency.linked_list", "technique");
  sheets::add(scene, {{.color = {0, 0, 0}, .alpha = 0.37f}});
  scene.add("diffuse.lambert", "lambert");
  scene.set("sheet0.diffuse", "lambert");
  scene.set("sheet0.diffuse_color", "[1, 0.5, 0.01]");
  for (const float brightness : {1e-3f, 1.0f, 1.7f, 90.0f}) {
    scene.set("front.intensity", std::to_string(brightness));
    const Pixels pixels = scene.layer("transparent");
    const glm::vec3 wanted = 0.37f * brightness * glm::vec3(1, 0.5f, 0.01f);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(pixels.at(4, 4, c), wanted[c], exact * brightness);
  }
}

TEST(Peel, TakesTwoLayersPerDrawingAndStopsWhenNoneIsLeft) {
  for (const int count : {1, 2, 3, 4, 8}) {
    const auto list = sheets::shuffled(count, 7);
    Scene scene({9, 9});
    scene.add("transparency.peel", "technique");
    sheets::add(scene, list);
    for (const int peels : {(count + 1) / 2, 33}) {
      scene.set("technique.peels", std::to_string(peels));
      EXPECT_LT(sheets::largest_error(scene, list), exact) << count << " layers, " << peels << " peels";
      EXPECT_TRUE(scene.problems().empty());
    }
  }
}

TEST(Peel, BlendsAndReportsWhatIsLeftInTheMiddle) {
  const std::vector<Sheet> list = {{0.6f, {1, 0, 0}, 0.5f}, {0.2f, {0, 1, 0}, 0.5f}, {0, {0, 1, 0}, 0.5f}, {-0.2f, {0, 1, 0}, 0.5f}, {-0.6f, {0, 0, 1}, 0.5f}};
  Scene scene({9, 9});
  scene.add("transparency.peel", "technique", R"({"peels": 1})");
  sheets::add(scene, list);
  EXPECT_LT(sheets::largest_error(scene, list), exact) << "the middle layers have one color: the weighted sums are right";
  const auto problems = scene.problems();
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].message.find("243 fragments"), std::string::npos) << problems[0].message;  // 3 x 9 x 9
}

}  // namespace
