/// occlusion.stochastic_depth: what the front surface hides occludes as often as chance draws it, and surfaces hide no more than their thickness.

#include <gtest/gtest.h>

#include "occluders.h"

namespace {

using lumen::testing::Pixels;
using lumen::testing::Scene;

constexpr int size = 128;
constexpr const char* one_refinement = R"({"radius": 0.12, "samples": 64, "refinements": 1})";
constexpr const char* many_refinements = R"({"radius": 0.12, "thickness": 1, "samples": 32, "refinements": 16})";

/// A floor with a low step up from x = 0 on, and high over the step a roof, which hides the step from the eye and nothing from the floor.
void add_hidden_step(Scene& scene) {
  scene.surface("ground", occluders::wall(0.12f));
  scene.surface("roof", lumen::testing::moved(*lumen::testing::rectangle(1.1f, 2.2f), {0.55f, 0, 0.9f}));
}

/// On the floor, along the step.
float at_the_foot(Scene& scene) { return occluders::mean(scene.layer("occlusion"), size / 2 - 6, 16, size / 2 - 1, size - 16); }

float chance_to_see_the_second(float share, int depths) { return 1 - std::pow(1 - share * (1 - share), float(depths)); }

TEST(StochasticDepth, StepBehindARoofOccludesTheFloorThatIsSeen) {
  Scene scene({size, size});
  add_hidden_step(scene);
  for (const char* front_alone : {"occlusion.ssao", "occlusion.hbao"}) {
    scene.add(front_alone, front_alone + 10, R"({"radius": 0.12})");
    EXPECT_LT(at_the_foot(scene), 0.01f) << front_alone;
  }
  scene.add("occlusion.traced", "traced", R"({"radius": 0.12, "samples": 256, "samples_per_step": 256})");
  const float truth = at_the_foot(scene);
  EXPECT_GT(truth, 0.2f);
  scene.add("occlusion.stochastic_depth", "ao", many_refinements);
  EXPECT_GT(at_the_foot(scene), 0.2f * truth);  // as much as such samples see of a step in full view
  EXPECT_LT(at_the_foot(scene), truth + 0.05f);
  EXPECT_TRUE(scene.problems().empty());
}

TEST(StochasticDepth, HiddenSurfacesCountAsOftenAsChanceDrawsThem) {
  for (const char* projection : {"orthographic", "perspective"}) {
    Scene hidden({size, size}), seen({size, size});
    add_hidden_step(hidden);
    add_hidden_step(seen);
    for (Scene* scene : {&hidden, &seen}) {
      scene->set("camera.projection", projection);
      scene->set("camera.field_of_view", "12");
      scene->add("occlusion.stochastic_depth", "ao", many_refinements);
    }
    seen.set("roof.enabled", "false");
    seen.surface("far", lumen::testing::moved(*lumen::testing::rectangle(0.01f, 0.01f), {1.1f, 1.1f, 0.9f}));  // the scene's radius stays
    const float whole = at_the_foot(seen);
    ASSERT_GT(whole, 0.08f);
    for (const float share : {0.2f, 0.5f, 1.0f})
      for (const int depths : {1, 4}) {
        hidden.set_value("ao.share", lumen::Value(share));
        hidden.set_value("ao.depths", lumen::Value(depths));
        EXPECT_NEAR(at_the_foot(hidden), whole * chance_to_see_the_second(share, depths), 0.04f * whole) << projection << ", share " << share << ", depths " << depths;
      }
  }
}

TEST(StochasticDepth, IsSsaoWhereNothingIsHiddenAndSurfacesAreThick) {
  for (const char* projection : {"orthographic", "perspective"}) {
    Scene scene({size, size});
    scene.surface("ground", occluders::drawn_out({{-1.1f, 0.4f}, {-0.4f, -0.1f}, {0.1f, 0}, {0.3f, 0.15f}, {1.1f, 0}}, 1.1f));
    scene.set("camera.projection", projection);
    scene.set("camera.field_of_view", "12");
    scene.add("occlusion.ssao", "ssao", one_refinement);
    const Pixels expected = scene.layer("occlusion");
    ASSERT_GT(occluders::mean(expected, 38, 32, 44, 96), 0.05f);
    scene.add("occlusion.stochastic_depth", "ao", one_refinement);
    scene.set("ao.thickness", "4");
    EXPECT_LT(lumen::testing::largest_difference(scene.layer("occlusion"), expected), 0.02f) << projection;
  }
}

/// A plate over a floor, within the radius: what lies in its shadow by more than the thickness is open.
TEST(StochasticDepth, SurfacesHideNoMoreThanTheirThickness) {
  Scene scene({size, size});
  scene.surface("floor", lumen::testing::rectangle(2.2f, 2.2f));
  scene.surface("plate", lumen::testing::moved(*lumen::testing::rectangle(1.1f, 2.2f), {0.55f, 0, 0.2f}));
  scene.add("occlusion.stochastic_depth", "ao", R"({"radius": 0.12, "samples": 32, "refinements": 4, "thickness": 4})");
  const float thick = at_the_foot(scene);
  EXPECT_GT(thick, 0.08f);
  scene.set("ao.thickness", "0.1");
  EXPECT_LT(at_the_foot(scene), 0.3f * thick);
}

/// The drawings are not moved as antialiasing moves the layers: their depths are compared where they were drawn.
TEST(StochasticDepth, AntialiasedPlaneIsNotOccluded) {
  for (const char* projection : {"orthographic", "perspective"}) {
    Scene scene({64, 64});
    scene.surface("wall", lumen::testing::rectangle(20, 20),
                  R"({"ambient": "ambient", "ambient_color": [1, 1, 1], "transform": [0.75,0.25,0.6123724,0, 0.25,0.75,-0.6123724,0, -0.6123724,0.6123724,0.5,0, 0,0,0,1]})");
    scene.add("ambient.constant", "ambient");
    scene.add("occlusion.stochastic_depth", "ao", R"({"radius": 0.008, "bias": 0.01, "refinements": 2})");
    scene.set("camera.projection", projection);
    scene.set("camera.field_of_view", "12");
    scene.set("main.antialiasing", "16");
    const Pixels picture = scene.picture();
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) ASSERT_GE(picture.at(x, y), 1 - 1.0f / 255) << projection << " at " << x << ", " << y;
  }
}

}  // namespace
