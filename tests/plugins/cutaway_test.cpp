/// splitter.cutaway: nothing hides what is of interest, and the holes have the walls that they must.

#include <cmath>

#include <gtest/gtest.h>
#include <lumen/testing.h>

namespace {

using lumen::testing::Pixels;
using lumen::testing::Scene;

constexpr int side = 220;  // 100 pixels per world unit

/// A slab, front face at z = 0.5, before a ball of radius 0.2 at the origin.
void add_slab_and_ball(Scene& scene, const char* cutaway) {
  scene.add("diffuse.lambert", "lambert");
  scene.add("splitter.cutaway", "cutaway", cutaway);
  scene.surface("slab", lumen::testing::moved(*lumen::testing::box({2, 2, 0.1f}), {0, 0, 0.45f}), R"({"diffuse": "lambert", "splitter": "cutaway"})");
  scene.surface("ball", lumen::testing::sphere(128, 0.2f), R"({"diffuse": "lambert", "diffuse_color": [0, 1, 0]})");
}

/// How many pixels show the instance.
int shown(Scene& scene, int instance) {
  const Pixels id = scene.layer("id");
  int count = 0;
  for (int y = 0; y < id.height(); ++y)
    for (int x = 0; x < id.width(); ++x) count += int(id.at(x, y)) == instance;
  return count;
}

/// Which number the id layer gives to what is at this pixel.
int number_at(Scene& scene, int x, int y) { return int(scene.layer("id").at(x, y)); }

TEST(Cutaway, NothingOfInterestIsHidden) {
  for (const char* projection : {"orthographic", "perspective"}) {
    Scene scene({side, side});
    scene.set("camera.projection", projection);
    add_slab_and_ball(scene, R"({"interest": ["ball"]})");
    const int ball = number_at(scene, side / 2, side / 2);
    scene.set("slab.enabled", "false");
    const int alone = shown(scene, ball);
    scene.set("slab.enabled", "true");
    for (const char* slope : {"0", "40", "80"}) {
      scene.set("cutaway.slope", slope);
      EXPECT_EQ(shown(scene, ball), alone) << projection << ", slope " << slope;
    }
    EXPECT_TRUE(scene.problems().empty());
  }
}

TEST(Cutaway, TheHolesWallHasTheSlope) {
  Scene scene({side, side});
  add_slab_and_ball(scene, R"({"interest": ["ball"]})");
  for (const char* reduction : {"1", "4"}) {
    for (const float slope : {15.0f, 35.0f, 50.0f}) {
      scene.set("cutaway.slope", std::to_string(slope));
      scene.set("cutaway.reduction", reduction);
      // The cone that touches the ball from behind: its axis goes through the center, 0.5 behind the slab's front.
      const float radius = 0.2f / std::cos(glm::radians(slope)) + 0.5f * std::tan(glm::radians(slope));
      const Pixels depth = scene.layer("depth");
      for (const glm::ivec2 way : {glm::ivec2(1, 0), glm::ivec2(0, -1), glm::ivec2(-1, 1)}) {
        glm::ivec2 at(side / 2);
        int steps = 0;
        while (depth.at(at.x, at.y) > 9.51f) at += way, ++steps;
        EXPECT_NEAR(float(steps) * glm::length(glm::vec2(way)), radius * 100, 2) << "slope " << slope << ", reduction " << reduction << ", way " << way.x << " " << way.y;
      }
    }
  }
}

TEST(Cutaway, InPerspectiveTheWallLeavesTheLineOfSightByTheSlope) {
  Scene scene({side, side});
  scene.set("camera.projection", "perspective");
  scene.set("camera.field_of_view", "20");
  add_slab_and_ball(scene, R"({"interest": ["ball"], "slope": 35, "margin": 0})");
  const float half = std::tan(glm::radians(10.0f));
  // Which point q of the ball's back reaches farthest at the slab's front, 9.5 = z_q / (1 + cot(slope) |p - q|).
  float radius = 0;
  for (float angle = 0; angle < 1.5f; angle += 0.001f) {
    const float depth = 10 + 0.2f * std::sin(angle);
    radius = std::max(radius, 0.2f * std::cos(angle) / depth + (depth / 9.5f - 1) * std::tan(glm::radians(35.0f)));
  }
  const Pixels depth = scene.layer("depth");
  int steps = 0;
  while (depth.at(side / 2 + steps, side / 2) > 9.51f) ++steps;
  EXPECT_NEAR(float(steps), radius / half * side / 2, 2);
}

TEST(Cutaway, CutsNothingThatIsBehind) {
  Scene scene({side, side});
  add_slab_and_ball(scene, R"({"interest": ["ball"]})");
  scene.set("slab.transform", "[1,0,0,0, 0,1,0,0, 0,0,1,-1.5, 0,0,0,1]");
  const Pixels cut = scene.layer("color");
  scene.set("slab.splitter", "[]");
  EXPECT_EQ(lumen::testing::largest_difference(cut, scene.layer("color")), 0);
}

TEST(Cutaway, TheGhostIsExactlyWhatIsCut) {
  Scene scene({side, side});
  add_slab_and_ball(scene, R"({"interest": ["ball"]})");
  const Pixels rest = scene.layer("depth");
  scene.set("cutaway.keep", "removed");
  const Pixels ghost = scene.layer("depth");
  int wrong = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      // The slab's front face is in one of the pictures, never in both.
      const bool in_rest = std::abs(rest.at(x, y) - 9.5f) < 1e-3f, in_ghost = std::abs(ghost.at(x, y) - 9.5f) < 1e-3f;
      const bool slab = std::abs(float(x) - 109.5f) < 99 && std::abs(float(y) - 109.5f) < 99;
      wrong += slab && in_rest == in_ghost;
    }
  EXPECT_EQ(wrong, 0);
}

TEST(Cutaway, TheCutIsLitAsItsWall) {
  Scene scene({side, side});
  add_slab_and_ball(scene, R"({"interest": ["ball"], "slope": 45})");
  const Pixels normal = scene.layer("normal"), depth = scene.layer("depth");
  // The back of the slab, seen through the hole, between the holes' radii in its back (0.68) and its front (0.78).
  const int x = side / 2 + 73;
  EXPECT_NEAR(depth.at(x, side / 2), 9.6f, 1e-3f);
  EXPECT_NEAR(normal.at(x, side / 2, 0), -std::sqrt(0.5f), 0.02f);
  EXPECT_NEAR(normal.at(x, side / 2, 1), 0, 0.02f);
  EXPECT_NEAR(normal.at(x, side / 2, 2), std::sqrt(0.5f), 0.02f);
}

TEST(Cutaway, PartsOfTheSurfaceItselfStayWholeAndInSight) {
  Scene scene({side, side});
  scene.add("diffuse.lambert", "lambert");
  scene.add("splitter.cutaway", "cutaway", R"({"parts": [6]})");
  // The flat faces of a box are not connected: parts 0 to 5.
  const auto slab = lumen::testing::moved(*lumen::testing::box({2, 2, 0.1f}), {0, 0, 0.45f});
  const std::vector<std::shared_ptr<lumen::Mesh>> both = {slab, lumen::testing::sphere(128, 0.2f)};
  scene.surface("both", lumen::testing::joined(both), R"({"diffuse": "lambert", "splitter": "cutaway"})");
  const Pixels depth = scene.layer("depth");
  for (const int off : {0, 10, 19}) EXPECT_NEAR(depth.at(side / 2 + off, side / 2), 10 - std::sqrt(0.04f - off * off * 1e-4f), 0.02f) << off;
  EXPECT_NEAR(depth.at(10 + 5, side / 2), 9.5f, 1e-3f);
}

TEST(Cutaway, TheSameSessionIsTheSamePicture) {
  Scene scene({side, side});
  add_slab_and_ball(scene, R"({"interest": ["ball"], "reduction": 3})");
  const Pixels before = scene.picture();
  scene.set("ball.transform", "[1,0,0,0.4, 0,1,0,0, 0,0,1,0, 0,0,0,1]");
  EXPECT_GT(lumen::testing::largest_difference(before, scene.picture()), 0.1f);
  scene.set("ball.transform", "[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]");
  EXPECT_EQ(lumen::testing::largest_difference(before, scene.picture()), 0);
}

TEST(Cutaway, SaysWhenThereIsNothingOfInterest) {
  Scene scene({64, 64});
  add_slab_and_ball(scene, R"({"interest": ["nobody"]})");
  EXPECT_NEAR(scene.layer("depth").at(32, 32), 9.5f, 1e-3f);
  bool said = false;
  for (const lumen::Problem& problem : scene.problems()) said = said || problem.message.find("nothing of interest") != std::string::npos;
  EXPECT_TRUE(said);
}

}  // namespace
