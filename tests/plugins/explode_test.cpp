// splitter.explode: what stays in place, where forces are in equilibrium, and that no part moves through another.
#include <algorithm>
#include <random>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <lumen/components.h>
#include <lumen/splitter.h>

#include "explode_shapes.h"

namespace {

using namespace explode_shapes;
using lumen::testing::Scene;

/// The real splitter, asked for its parts.
struct Exploded {
  Scene scene;
  lumen::Splitter& splitter;
  std::shared_ptr<const lumen::Mesh> mesh;
  lumen::Camera camera{.view = glm::translate(glm::mat4(1), {0, 0, -10}), .distance = 10};

  Exploded(std::shared_ptr<const lumen::Mesh> shape, std::string_view properties)
      : splitter(static_cast<lumen::Splitter&>(scene.add("splitter.explode", "parts", properties))), mesh(std::move(shape)) {}
  lumen::Split split() {
    return splitter.split({.mesh = mesh, .object_to_world = glm::mat4(1), .bounds = mesh->bounds(), .camera = camera});
  }
  lumen::Split split(float degree) {
    scene.set_value("parts.degree", degree);
    return split();
  }
  glm::vec3 move(const lumen::Split& split, std::size_t part) const { return glm::vec3(split.parts.at(part).transform[3]); }
  bool reports(std::string_view words) const {
    const auto problems = scene.problems();
    return std::any_of(problems.begin(), problems.end(), [&](const auto& problem) { return problem.message.find(words) != std::string::npos; });
  }
};

/// Every pair that is apart at rest is apart.
void expect_apart(const lumen::Mesh& mesh, const lumen::Split& split, const std::vector<std::pair<std::size_t, std::size_t>>& pairs, const std::string& when) {
  const auto parts = drawn(mesh, split);
  for (const auto& [a, b] : pairs) {
    const bool moved = split.parts[a].transform != split.parts[b].transform;
    EXPECT_FALSE(moved && intersect(parts[a], parts[b])) << "parts " << a << " and " << b << " at " << when;
  }
}

std::vector<std::pair<std::size_t, std::size_t>> apart_at_rest(const lumen::Mesh& mesh, const lumen::Split& rest) {
  const auto parts = drawn(mesh, rest);
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t a = 0; a < parts.size(); ++a)
    for (std::size_t b = a + 1; b < parts.size(); ++b)
      if (!intersect(parts[a], parts[b])) pairs.emplace_back(a, b);
  return pairs;
}

struct Shape {
  const char* name;
  MeshPointer (*make)();
  int moving;  ///< parts that come out
  const char* properties = R"({"layout": "graph"})";
};

class ExplodeGraph : public testing::TestWithParam<Shape> {};

TEST_P(ExplodeGraph, NoPartMovesThroughAnother) {
  Exploded exploded(GetParam().make(), GetParam().properties);
  const auto pairs = apart_at_rest(*exploded.mesh, exploded.split(0));
  EXPECT_FALSE(pairs.empty());
  for (int step = 0; step <= 80; ++step) {  // four to each .05 of the degree: the ways between them, too
    const float degree = float(step) / 80;
    expect_apart(*exploded.mesh, exploded.split(degree), pairs, "degree " + std::to_string(degree));
  }
  const lumen::Split out = exploded.split(1);
  int moving = 0;
  for (const lumen::Part& part : out.parts) moving += part.transform != glm::mat4(1);
  EXPECT_EQ(moving, GetParam().moving);
}

TEST_P(ExplodeGraph, NorWhateverIsPulledOutAtOnce) {
  Exploded exploded(GetParam().make(), GetParam().properties);
  const lumen::Split rest = exploded.split(0);
  const auto pairs = apart_at_rest(*exploded.mesh, rest);
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(-0.5f, 1.2f);
  for (int i = 0; i < 25; ++i) {
    std::vector<float> pulled(rest.parts.size());
    for (float& part : pulled) part = std::clamp(uniform(random), 0.0f, 1.0f);
    exploded.scene.set_value("parts.pulled", pulled);
    expect_apart(*exploded.mesh, exploded.split(), pairs, "pull " + std::to_string(i));
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, ExplodeGraph,
                         testing::Values(Shape{"stack", [] { return stack(6); }, 5}, Shape{"rings_on_rod", rings_on_rod, 3}, Shape{"bottle", bottle, 2}, Shape{"shells", shells, 1},
                                         Shape{"drawer", drawer, 7}, Shape{"faces", faces, 17},
                                         Shape{"bolted_drawer", bolted_drawer, 2, R"({"layout": "graph", "selection": [2, 3, 4, 5, 6, 7, 8, 9, 10]})"}),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(Explode, AtDegreeZeroEveryPartIsWhereItWasToTheBit) {
  for (const char* layout : {"forces", "graph"}) {
    Exploded exploded(bottle(), R"({"selection": [0]})");
    exploded.scene.set("parts.layout", layout);
    for (const float degree : {0.0f, 0.7f, 0.0f}) {
      const lumen::Split split = exploded.split(degree);
      ASSERT_EQ(split.parts.size(), 4u);
      for (const lumen::Part& part : split.parts) {
        const bool stays = degree == 0 || part.group == 0;
        if (stays) {
          EXPECT_EQ(part.transform, glm::mat4(1)) << layout;
        }
      }
    }
  }
}

TEST(Explode, AtDegreeZeroThePictureIsThatOfTheSurface) {
  Scene scene({96, 96});
  scene.add("diffuse.lambert", "lambert");
  scene.add("splitter.explode", "parts", R"({"degree": 0})");
  scene.surface("bottle", bottle(), R"({"diffuse": "lambert", "splitter": "parts"})");
  const auto split = scene.layer("color");
  scene.set("bottle.splitter", "\"\"");
  EXPECT_EQ(lumen::testing::largest_difference(split, scene.layer("color")), 0);
  scene.set("bottle.splitter", "parts");
  scene.set("parts.degree", "0.5");
  EXPECT_GT(lumen::testing::largest_difference(split, scene.layer("color")), 0.1f);
}

TEST(Explode, RingsLeaveTheRodAlongIt) {
  Exploded exploded(rings_on_rod(), R"({"layout": "graph", "spacing": 0.1})");
  const lumen::Split split = exploded.split(1);
  EXPECT_EQ(split.parts[0].transform, glm::mat4(1));
  const float gap = 0.1f * exploded.mesh->bounds().radius();
  // Beyond the rod's ends by the gap; the lowest not behind the middle one, which takes the same way.
  const float expected[] = {0, -2 - gap, -2 - gap, 2 + gap - 0.1f};
  for (std::size_t ring = 1; ring < 4; ++ring) {
    const glm::vec3 move = exploded.move(split, ring);
    EXPECT_NEAR(glm::length(glm::vec2(move)), 0, 1e-5f);
    EXPECT_NEAR(move.z, expected[ring], 1e-4f) << ring;
  }
}

TEST(Explode, BoxesOfAStackAreTheGapApart) {
  Exploded exploded(stack(5), R"({"layout": "graph", "spacing": 0.1})");
  const lumen::Split split = exploded.split(1);
  const float gap = 0.1f * exploded.mesh->bounds().radius();
  std::vector<float> height;
  for (std::size_t i = 0; i < 5; ++i) {
    const glm::vec3 move = exploded.move(split, i);
    EXPECT_NEAR(glm::length(glm::vec2(move)), 0, 1e-5f);
    height.push_back(0.5f * float(i) + move.z);
  }
  for (std::size_t i = 1; i < 5; ++i) EXPECT_NEAR(height[i] - height[i - 1], 0.5f + gap, 1e-4f);
  EXPECT_EQ(split.parts[2].transform, glm::mat4(1));
}

TEST(Explode, WhatAPartHoldsStaysWithItAndIsReported) {
  Exploded exploded(shells(), R"({"layout": "graph", "selection": [3]})");
  const lumen::Split split = exploded.split(1);
  EXPECT_EQ(split.parts[3].transform, glm::mat4(1));
  EXPECT_NE(split.parts[0].transform, glm::mat4(1));
  EXPECT_EQ(split.parts[1].transform, split.parts[0].transform);
  EXPECT_EQ(split.parts[2].transform, split.parts[0].transform);
  EXPECT_TRUE(exploded.reports("2 parts stay with the ones that hold them"));
}

TEST(Explode, AnExposedPartTakesAlongWhatIsInItsWayAndNothingElse) {
  Exploded exploded(rings_on_rod(), R"({"layout": "graph", "exposed": [2]})");
  const lumen::Split split = exploded.split(1);
  EXPECT_NE(split.parts[2].transform, glm::mat4(1));
  const bool up = exploded.move(split, 2).z > 0;
  EXPECT_NE(split.parts[up ? 3 : 1].transform, glm::mat4(1));
  EXPECT_EQ(split.parts[up ? 1 : 3].transform, glm::mat4(1));
  EXPECT_EQ(split.parts[0].transform, glm::mat4(1));
}

TEST(Explode, PrincipalAxesFollowAShapeThatIsTurned) {
  const glm::mat4 turn = glm::rotate(glm::mat4(1), 0.7f, glm::normalize(glm::vec3(1, 2, 0.5f)));
  Exploded exploded(rings_on_rod(), R"({"layout": "graph", "axes": "principal", "degree": 1})");
  const lumen::Split split =
      exploded.splitter.split({.mesh = exploded.mesh, .object_to_world = turn, .bounds = exploded.mesh->bounds().transformed(turn), .camera = exploded.camera});
  const glm::vec3 along(turn * glm::vec4(0, 0, 1, 0));
  for (const std::size_t part : {1u, 2u, 3u}) {
    const glm::vec3 move = exploded.move(split, part);
    EXPECT_NEAR(std::abs(glm::dot(glm::normalize(move), along)), 1, 1e-4f);
    EXPECT_GT(glm::length(move), 0.5f);
  }
}

TEST(Explode, PartsThatMeetAtRestAreToldAndDoNotHoldEachOther) {
  Exploded exploded(lumen::testing::joined({ball(1), ball(0.5f, {0.9f, 0, 0})}), R"({"layout": "graph"})");
  EXPECT_NE(exploded.split(1).parts[1].transform, glm::mat4(1));
  EXPECT_TRUE(exploded.reports("1 pairs of parts meet where they are"));
}

/// A tiny box at the origin that stays, and one at x = 1.
MeshPointer two_boxes() {
  return lumen::testing::joined({box(glm::vec3(1e-3f)), box(glm::vec3(0.2f), {1, 0, 0})});
}

TEST(Explode, ForcesAreInEquilibrium) {
  Exploded exploded(two_boxes(), R"({"selection": [0], "return_force": 1.3, "explosion_force": 0.8, "viewing_force": 0, "spacing_force": 0.4})");
  for (const float degree : {0.25f, 1.0f}) {
    const glm::vec3 move = exploded.move(exploded.split(degree), 1);
    // Equations of the paper's section 3.2 along the line of both, in radii of the surface, solved by bisection.
    const double radius = double(exploded.mesh->bounds().radius());
    double low = 0, high = 10;
    for (int i = 0; i < 60; ++i) {
      const double x = 0.5 * (low + high), back = 1.3 * std::log1p(x);
      const double explosion = 0.8 * std::exp(-(0.9 / radius + x)), spacing = 0.4 / 2 / std::pow(1 / radius + x, 2);
      (back < double(degree) * (explosion + spacing) ? low : high) = x;
    }
    EXPECT_NEAR(move.x, low * radius, 2e-3);
    EXPECT_NEAR(glm::length(glm::vec2(move.y, move.z)), 0, 2e-3f);
  }
}

TEST(Explode, TheViewingForceUncoversTheSelection) {
  const auto seen = [](const char* force) {
    Scene scene({128, 128});
    const auto plate = box({1.2f, 1, 0.1f}, {0.05f, 0, 0.8f});
    scene.add("splitter.explode", "parts", R"({"selection": [0], "degree": 1, "explosion_force": 0.3})");
    scene.set("parts.viewing_force", force);
    scene.surface("both", lumen::testing::joined({ball(0.4f), plate}), R"({"splitter": "parts"})");
    const auto id = scene.layer("id");
    int pixels = 0;
    for (int y = 0; y < 128; ++y)
      for (int x = 0; x < 128; ++x) pixels += id.at(x, y, 0) > 0 && id.at(x, y, 1) == 1;
    return pixels;
  };
  const int hidden = seen("0"), shown = seen("1");
  EXPECT_LT(hidden, 100) << "of about 1700 pixels that the ball covers";
  EXPECT_GT(shown, 1000);
}

TEST(Explode, TheLayoutDependsOnNothingThatWasBefore) {
  for (const char* layout : {"forces", "graph"}) {
    Exploded fresh(drawer(), "{}"), used(drawer(), "{}");
    fresh.scene.set("parts.layout", layout);
    used.scene.set("parts.layout", layout);
    used.split(1);
    const lumen::Split between = used.split(0.2f), after = used.split(0.6f);
    EXPECT_EQ(between.groups, after.groups) << "only the degree has changed: nothing is grouped again";
    const lumen::Split first = fresh.split(0.6f);
    ASSERT_EQ(first.parts.size(), after.parts.size());
    for (std::size_t i = 0; i < first.parts.size(); ++i) EXPECT_EQ(first.parts[i], after.parts[i]);
  }
}

TEST(Explode, PartsAreThoseOfAnArray) {
  MeshPointer mesh = stack(4);
  std::vector<float> half(mesh->triangles.size(), 7);
  std::fill(half.begin(), half.begin() + std::ptrdiff_t(half.size() / 2), 3.0f);
  mesh->attributes.push_back({.name = "half", .on = lumen::Attribute::On::cells, .values = half});
  Exploded exploded(mesh, R"({"group_by": "half", "layout": "graph"})");
  const lumen::Split split = exploded.split(1);
  ASSERT_EQ(split.parts.size(), 2u);
  EXPECT_EQ((*split.groups)[0], 0u);
  EXPECT_EQ(split.groups->back(), 1u);
  exploded.scene.set("parts.group_by", "third");
  EXPECT_THROW(exploded.split(), lumen::Error);
}

TEST(Explode, ACutPartTakesAlongItsOwnCapAlone) {
  for (const char* order : {R"(["cut", "parts"])", R"(["parts", "cut"])"}) {
    Scene scene({220, 220});  // 100 pixels per world unit, seen from +z
    scene.add("splitter.plane", "cut");
    scene.add("splitter.explode", "parts", R"({"layout": "graph", "spacing": 0.5, "degree": 1})");
    scene.surface("boxes", lumen::testing::joined({box(glm::vec3(0.4f), {-0.5f, 0, 0}), box(glm::vec3(0.4f), {0.5f, 0, 0})}));
    scene.set("boxes.splitter", order);
    const auto depth = scene.layer("depth");
    int covered = 0;
    for (int y = 0; y < 220; ++y)
      for (int x = 0; x < 220; ++x) covered += !std::isinf(depth.at(x, y));
    EXPECT_EQ(covered, 2 * 40 * 40) << order;
    EXPECT_TRUE(scene.problems().empty());
  }
}

TEST(Explode, OfTooManyPartsTheSmallestStay) {
  std::vector<MeshPointer> boxes;
  for (int i = 0; i < 600; ++i) {
    const int detail = i < 550 ? 6 : 4;
    boxes.push_back(lumen::testing::moved(*lumen::testing::sphere(detail, 0.2f), {i % 10, i / 10 % 10, i / 100}));
  }
  Exploded exploded(lumen::testing::joined(boxes), R"({"layout": "forces"})");
  const lumen::Split split = exploded.split(1);
  EXPECT_EQ(split.parts.size(), 512u);
  EXPECT_TRUE(exploded.reports("600 parts"));
  EXPECT_EQ((*split.groups)[split.groups->size() - 1], (*split.groups)[split.groups->size() - 40]) << "the last two are left together";
}

}  // namespace
