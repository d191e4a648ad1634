/// splitter.plane: what the cut looks like inside, what its caps hold, and what stays whole.

#include <cmath>
#include <set>

#include <gtest/gtest.h>
#include <lumen/components.h>
#include <lumen/splitter.h>
#include <lumen/testing.h>

namespace {

using lumen::testing::Pixels;
using lumen::testing::Scene;

constexpr float pi = 3.14159265f;

/// A ball cut by a plane at distance h from its center, the normal turned by 10 degrees from the eye. The camera looks at the far
/// half; the other is out of sight.
struct CutBall {
  static constexpr float sine = 0.17364818f, cosine = 0.98480775f, offset = 20;
  Scene scene;
  explicit CutBall(const char* interior, float h = 0, int pixels = 220) : scene({pixels, pixels}) {
    scene.add("ambient.constant", "ambient");
    scene.add("diffuse.lambert", "diffuse");
    scene.add("specular.blinn", "specular");
    scene.add("splitter.plane", "cut", R"({"angle": 10, "offset": 20, "interior_color": [0.2, 0.4, 0.8]})");
    scene.set("cut.interior", interior);
    scene.set("cut.translation", along(h));
    scene.set("camera.pivot", along(-offset));
    scene.surface("ball", lumen::testing::sphere(256), R"({"ambient": "ambient", "diffuse": "diffuse", "specular": "specular", "splitter": ["cut"]})");
  }
  static std::string along(float way) { return "[" + std::to_string(way * sine) + ", 0, " + std::to_string(way * cosine) + "]"; }
};

/// Pixels where the layer shows the inside's color.
template <class Is>
int count(const Pixels& pixels, Is is) {
  int found = 0;
  for (int y = 0; y < pixels.height(); ++y)
    for (int x = 0; x < pixels.width(); ++x) found += is(x, y) ? 1 : 0;
  return found;
}

TEST(PlaneCap, HasTheAreaOfItsCircle) {
  for (const float h : {0.0f, 0.3f, 0.6f, -0.6f}) {
    CutBall ball("cap", h, 440);  // 200 pixels per world unit
    const Pixels id = ball.scene.layer("id");
    const int inside = count(id, [&](int x, int y) { return id.at(x, y, 1) == 2 && id.at(x, y, 2) == 0; });
    const float wanted = pi * (1 - h * h) * CutBall::cosine;
    EXPECT_NEAR(float(inside) / (200 * 200), wanted, 0.01f * wanted) << "h = " << h;
    EXPECT_EQ(ball.scene.problems().size(), 0u);
  }
}

TEST(PlaneCap, LiesInThePlaneAndHidesWhatIsBehindIt) {
  CutBall ball("cap");
  // A small ball wholly inside the half that is looked into: a hollow half would show it.
  ball.scene.surface("seed", lumen::testing::moved(*lumen::testing::sphere(32, 0.2f), glm::vec3(CutBall::sine, 0, CutBall::cosine) * -20.5f));
  const Pixels depth = ball.scene.layer("depth"), normal = ball.scene.layer("normal");
  for (const auto& [x, y] : {std::pair(110, 110), std::pair(60, 110), std::pair(110, 190)}) {
    const float across = (float(x) + 0.5f - 110) / 100;  // the camera is 10 from its pivot, which is on the plane
    EXPECT_NEAR(depth.at(x, y), 10 + across * CutBall::sine / CutBall::cosine, 1e-4f);
    EXPECT_NEAR(normal.at(x, y, 0), CutBall::sine, 1e-5f);
    EXPECT_NEAR(normal.at(x, y, 2), CutBall::cosine, 1e-5f);
  }
}

TEST(PlaneInterior, LooksAsAsked) {
  const auto inside = [](const char* look, const char* layer) { return CutBall(look).scene.layer(layer).rgb(150, 110); };
  const auto expect_near = [](glm::vec3 value, glm::vec3 wanted) { EXPECT_LT(glm::length(value - wanted), 2e-3f) << value.x << " " << value.y << " " << value.z; };
  const float x = (150.5f - 110) / 100, y = (110 - 110.5f) / 100, z = std::sqrt(1 - x * x - y * y);
  expect_near(inside("flat", "color"), {0.2f, 0.4f, 0.8f});
  expect_near(inside("flat", "diffuse"), glm::vec3(0));
  expect_near(inside("none", "normal"), {-x, -y, z});
  expect_near(inside("lit", "normal"), {-x, -y, z});
  expect_near(inside("cut_surface", "normal"), {CutBall::sine, 0, CutBall::cosine});
  expect_near(inside("cap", "normal"), {CutBall::sine, 0, CutBall::cosine});
  EXPECT_NEAR(inside("lit", "ambient").b / inside("lit", "ambient").r, 4, 0.01f);
  EXPECT_GT(inside("none", "ambient").r, inside("none", "ambient").b);  // the surface's own red
  // The light is the eye's: Lambert's term is the normal's z.
  EXPECT_NEAR(inside("lit", "diffuse").g / inside("cut_surface", "diffuse").g, z / CutBall::cosine, 0.01f);
}

TEST(PlaneInterior, ColorsDrawNoGeometryAgain) {
  CutBall ball("cut_surface");
  ball.scene.layer("diffuse");
  const int geometry = ball.scene.runs("geometry"), lighting = ball.scene.runs("lighting");
  ball.scene.set("cut.interior_color", "[0, 1, 0]");
  EXPECT_EQ(ball.scene.layer("diffuse").at(150, 110, 2), 0);
  EXPECT_EQ(ball.scene.runs("geometry"), geometry);
  EXPECT_EQ(ball.scene.runs("lighting"), lighting + 1);
}

TEST(PlaneSplitter, CappedAndHollowHalvesShowTheSameOutside) {
  Scene capped({200, 200}), hollow({200, 200});
  for (Scene* scene : {&capped, &hollow}) {
    scene->add("splitter.plane", "cut", R"({"axis": [0, 1, 0], "angle": 60, "offset": 0.2})");
    scene->set("cut.interior", scene == &capped ? "cap" : "none");
    scene->surface("ball", lumen::testing::sphere(256), R"({"splitter": ["cut"]})");
  }
  const Pixels a = capped.layer("depth"), b = hollow.layer("depth"), id = capped.layer("id");
  int different = 0, covered = 0;
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x) {
      if (id.at(x, y, 0) == 0 || id.at(x, y, 2) == 0) continue;  // background, or a cap
      ++covered;
      different += std::abs(a.at(x, y) - b.at(x, y)) > 1e-4f;
    }
  EXPECT_GT(covered, 10000);
  EXPECT_LE(different, covered / 1000);
}

TEST(PlaneSplitter, KeepsSelectedPartsWholeAndInPlace) {
  // Two balls in one mesh; the second connected part stays.
  Scene scene({220, 110});
  scene.set("camera.height", "2.2");
  const auto balls = lumen::testing::joined({lumen::testing::moved(*lumen::testing::sphere(64, 0.5f), {-1, 0, 0}), lumen::testing::moved(*lumen::testing::sphere(64, 0.5f), {1, 0, 0})});
  scene.add("splitter.plane", "cut", R"({"axis": [1, 0, 0], "angle": 90, "offset": 0.3, "whole": [1]})");
  scene.surface("balls", balls, R"({"splitter": ["cut"]})");
  const Pixels depth = scene.layer("depth"), id = scene.layer("id");
  EXPECT_TRUE(std::isinf(depth.at(60, 55)));    // the gap
  EXPECT_FALSE(std::isinf(depth.at(160, 55)));  // whole
  EXPECT_EQ(id.at(160, 55, 1), 3);
  EXPECT_FALSE(std::isinf(depth.at(60, 15)));   // a half, moved up
  EXPECT_TRUE(std::isinf(depth.at(160, 20)));
}

TEST(PlaneSplitter, CutsThroughTheMiddleOfWhatItCutsUnlessSet) {
  Scene scene({110, 110});
  scene.add("splitter.plane", "cut", R"({"axis": [0, 1, 0], "angle": 90, "offset": 0.2})");
  scene.surface("left", lumen::testing::moved(*lumen::testing::sphere(32, 0.5f), {40, 30, 20}), R"({"splitter": ["cut"]})");
  scene.layer("depth");
  const auto middle = [&] { return std::get<glm::vec3>(scene.value("cut.translation")); };
  EXPECT_LT(glm::distance(middle(), glm::vec3(40, 30, 20)), 1e-3f);
  scene.surface("right", lumen::testing::moved(*lumen::testing::sphere(32, 0.5f), {44, 30, 20}), R"({"splitter": ["cut"]})");
  scene.layer("depth");
  EXPECT_LT(glm::distance(middle(), glm::vec3(42, 30, 20)), 1e-3f) << "of both";
  scene.set("cut.translation", "[41, 30, 20]");
  scene.layer("depth");
  EXPECT_EQ(middle(), glm::vec3(41, 30, 20));
}

TEST(PlaneSplitter, KeepsPartsThatAnArrayTellsApart) {
  // One ball, whose array says that its upper half is another part.
  Scene scene({220, 220});
  const auto ball = std::make_shared<lumen::Mesh>(*lumen::testing::sphere(64));
  lumen::Attribute part{.name = lumen::part_array, .on = lumen::Attribute::On::cells, .components = 1};
  std::vector<float> values;
  for (const glm::uvec3& triangle : ball->triangles)
    values.push_back(ball->positions[triangle.x].y + ball->positions[triangle.y].y + ball->positions[triangle.z].y > 0 ? 7.0f : 3.0f);
  part.values = std::move(values);
  ball->attributes.push_back(std::move(part));
  ball->finish();
  scene.add("splitter.plane", "cut", R"({"axis": [0, 1, 0], "angle": 90, "offset": 0.3, "interior": "none", "whole": [1]})");
  scene.surface("ball", ball, R"({"splitter": ["cut"]})");
  const Pixels depth = scene.layer("depth"), id = scene.layer("id");
  EXPECT_FALSE(std::isinf(depth.at(110, 60))) << "whole";
  EXPECT_EQ(id.at(110, 60, 1), 3);
  EXPECT_TRUE(std::isinf(depth.at(110, 160))) << "the gap";
}

TEST(PlaneSplitter, DraggingFindsAnewOnlyWhatItMust) {
  Scene scene({64, 64});
  const std::shared_ptr<const lumen::Mesh> balls =
      lumen::testing::joined({lumen::testing::moved(*lumen::testing::sphere(32, 0.5f), {-1, 0, 0}), lumen::testing::moved(*lumen::testing::sphere(32, 0.5f), {1, 0, 0})});
  auto& cut = static_cast<lumen::Splitter&>(scene.add("splitter.plane", "cut", R"({"offset": 0.1, "whole": [1]})"));
  const lumen::Camera camera;
  const auto split = [&] { return cut.split({.mesh = balls, .bounds = balls->bounds(), .camera = camera}); };
  const lumen::Split first = split();
  ASSERT_EQ(first.caps.size(), 2u);
  scene.set("cut.offset", "0.4");
  const lumen::Split apart = split();
  EXPECT_EQ(apart.caps[0].shape, first.caps[0].shape) << "the caps move, and stay what they are";
  EXPECT_EQ(apart.groups, first.groups);
  EXPECT_NE(apart.parts[0].transform, first.parts[0].transform);
  scene.set("cut.translation", "[0, 0, 0.2]");
  const lumen::Split moved = split();
  EXPECT_NE(moved.caps[0].shape, first.caps[0].shape);
  EXPECT_EQ(moved.groups, first.groups) << "what stays whole is not sought again";
}

TEST(PlaneSplitter, ItsRectangleIsDraggedWithoutDrawingTheOpaqueSceneAgain) {
  Scene scene({64, 64});
  scene.add("diffuse.lambert", "lambert");
  scene.add("opacity.constant", "faint", R"({"alpha": 0.3})");
  scene.add("transparency.weighted", "weighted");
  scene.add("occlusion.ssao", "ssao");
  scene.surface("ball", lumen::testing::sphere(32), R"({"diffuse": "lambert"})");
  scene.add("renderer.plane", "plane", R"({"opacity": "faint", "diffuse": "lambert", "translation": [0, 0, 1.2], "scale": [1, 1]})");
  const float before = scene.layer("color").at(32, 32, 0);
  const int geometry = scene.runs("geometry"), occlusion = scene.runs("ssao"), lighting = scene.runs("lighting"), transparent = scene.runs("weighted");
  scene.set("plane.diffuse_color", "[0, 1, 0]");
  EXPECT_NE(scene.layer("color").at(32, 32, 0), before);
  EXPECT_EQ(scene.runs("geometry"), geometry);
  EXPECT_EQ(scene.runs("ssao"), occlusion);
  EXPECT_EQ(scene.runs("lighting"), lighting);
  EXPECT_GT(scene.runs("weighted"), transparent);
}

TEST(PlaneSplitter, SeveralPlanesCutEachOthersHalves) {
  Scene scene({220, 220});
  scene.add("splitter.plane", "across", R"({"axis": [0, 1, 0], "angle": 90, "offset": 0.1})");
  scene.add("splitter.plane", "along", R"({"axis": [1, 0, 0], "angle": 90, "offset": 0.2})");
  scene.surface("ball", lumen::testing::sphere(64), R"({"splitter": ["across", "along"]})");
  const Pixels depth = scene.layer("depth"), id = scene.layer("id");
  EXPECT_TRUE(std::isinf(depth.at(110, 60)));
  EXPECT_TRUE(std::isinf(depth.at(60, 110)));
  std::set<float> parts;
  for (const auto& [x, y] : {std::pair(70, 70), std::pair(150, 70), std::pair(70, 150), std::pair(150, 150)}) parts.insert(id.at(x, y, 1));
  EXPECT_EQ(parts, (std::set<float>{1, 2, 3, 4}));
}

TEST(PlaneSplitter, OpensWhileWhatStaysWholeWouldBeHidden) {
  Scene scene({110, 110});
  const auto nested = lumen::testing::joined({lumen::testing::sphere(64), lumen::testing::sphere(32, 0.3f)});
  scene.add("splitter.plane", "cut", R"({"axis": [0, 1, 0], "angle": 90, "offset": 0.5, "whole": [1], "open_when_hidden": true})");
  scene.surface("balls", nested, R"({"splitter": ["cut"]})");
  EXPECT_EQ(scene.layer("id").at(55, 55, 1), 3);  // seen through the gap
  EXPECT_EQ(std::get<float>(scene.value("cut.opening")), 1);
  scene.give("balls_data", lumen::testing::joined({lumen::testing::moved(*lumen::testing::sphere(64), {0, 0, -3}), lumen::testing::sphere(32, 0.3f)}));
  scene.layer("id");
  EXPECT_EQ(std::get<float>(scene.value("cut.opening")), 0);  // in front by itself
}

TEST(PlaneSplitter, OpenMeshesAreSaidAndShowTheirInside) {
  Scene scene({110, 110});
  scene.add("splitter.plane", "cut", R"({"axis": [0, 1, 0], "angle": 90, "offset": 0.2})");
  scene.surface("plate", lumen::testing::rectangle(), R"({"splitter": ["cut"]})");
  scene.layer("depth");
  ASSERT_EQ(scene.problems().size(), 1u);
  EXPECT_EQ(scene.problems()[0].severity, lumen::Severity::note);
  EXPECT_NE(scene.problems()[0].message.find("border"), std::string::npos);
}

TEST(Surface, PartsTurnedInsideOutAreDrawnFromTheirOutside) {
  // Half of the ball's triangles are turned around, as segmentations leave them: still no inside is seen.
  const auto ball = lumen::testing::sphere(64);
  auto mixed = std::make_shared<lumen::Mesh>(*ball);
  std::vector<glm::uvec3> triangles(ball->triangles.begin(), ball->triangles.end());
  for (glm::uvec3& triangle : triangles)
    if (ball->positions[triangle.x].y > 0.5f) std::swap(triangle.y, triangle.z);
  mixed->triangles = std::move(triangles);
  mixed->finish();
  Scene scene({110, 110});
  scene.add("splitter.plane", "cut", R"({"translation": [0, 0, -5], "interior": "flat", "interior_color": [0, 0, 1]})");
  scene.surface("ball", mixed, R"({"diffuse_color": [1, 0, 0], "ambient_color": [1, 0, 0], "splitter": ["cut"]})");
  const Pixels color = scene.layer("color");
  for (int y = 10; y < 100; y += 5) EXPECT_EQ(color.at(55, y, 2), 0) << y;
}

}  // namespace
