/// What every transparency technique that is installed keeps, whatever it computes.

#include <cmath>

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "plugins/installed_types.h"
#include "transparent_sheets.h"

namespace {

using sheets::Pixels;
using sheets::Scene;
using sheets::Sheet;

const std::vector<std::string>& techniques() {
  static const std::vector<std::string> all = lumenshop::installed_types(lumen::Kind::transparency);
  return all;
}

/// Calls body(technique) while the scene is drawn by each technique in turn.
template <class Body>
void for_each_technique(Scene& scene, Body body) {
  for (std::size_t i = 0; i < techniques().size(); ++i) {
    SCOPED_TRACE(techniques()[i]);
    scene.add(techniques()[i], "technique" + std::to_string(i));
    body("technique" + std::to_string(i));
    for (const lumen::Problem& problem : scene.problems()) ADD_FAILURE() << problem.message;
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
  }
}

TEST(TransparencyTechniques, AreFound) { EXPECT_GE(techniques().size(), 6u); }

TEST(TransparencyTechniques, AreExactForOneLayer) {
  Scene scene({9, 9});
  sheets::add(scene, {{0.1f, {1, 0.5f, 0}, 0.5f}});
  for_each_technique(scene, [&](const std::string&) {
    for (const float alpha : {0.001f, 0.3f, 0.99f, 1.0f}) {
      scene.set("alpha0.alpha", std::to_string(alpha));
      EXPECT_LT(sheets::largest_error(scene, {{0.1f, {1, 0.5f, 0}, alpha}}), 1e-4f) << "alpha " << alpha;
    }
  });
}

TEST(TransparencyTechniques, LetTheBackgroundThroughAsTheProductOfWhatEachLayerDoes) {
  for (const int count : {2, 5, 12}) {
    const auto list = sheets::shuffled(count, unsigned(count), 0.4f);
    Scene scene({9, 9});
    sheets::add(scene, list);
    for_each_technique(scene, [&](const std::string&) {
      EXPECT_NEAR(scene.layer("opacity").at(4, 4), sheets::expected_at(list, {0, 0}).a, 1e-4f) << count << " layers";
    });
  }
}

TEST(TransparencyTechniques, KeepEqualColors) {
  auto list = sheets::shuffled(7, 4, 0.5f);
  for (Sheet& sheet : list) sheet.color = {0.8f, 0.4f, 0.2f};
  Scene scene({9, 9});
  sheets::add(scene, list);
  for_each_technique(scene, [&](const std::string&) { EXPECT_LT(sheets::largest_error(scene, list), 1e-4f); });
}

TEST(TransparencyTechniques, DoNotDependOnTheOrderOfDrawing) {
  auto list = sheets::shuffled(12, 9, 0.5f);
  Scene scene({9, 9}), other({9, 9});
  sheets::add(scene, list);
  std::reverse(list.begin(), list.end());
  std::swap(list[3], list[8]);
  sheets::add(other, list);
  for_each_technique(scene, [&](const std::string& technique) {
    other.add(techniques()[std::stoul(technique.substr(std::string_view("technique").size()))], technique);
    EXPECT_LT(lumen::testing::largest_difference(scene.layer("transparent"), other.layer("transparent")), 1e-3f);
  });
}

/// None is excepted: by default all of them see depth.
TEST(TransparencyTechniques, ShowWhichOfTwoLayersIsInFront) {
  for (const auto& [near, far] : {std::pair(10.0f, 20.0f), std::pair(300.0f, 320.0f)}) {
    Scene scene({9, 9});
    scene.set("camera.distance", std::to_string(near));
    sheets::add(scene, {{0, {1, 0, 0}, 0.5f}, {near - far, {0, 0, 1}, 0.5f}});
    for_each_technique(scene, [&](const std::string&) {
      const auto picture = [&](const char* first, const char* second) {
        scene.set("sheet0.ambient_color", first);
        scene.set("sheet1.ambient_color", second);
        return scene.layer("color");
      };
      const Pixels red = picture("[1, 0, 0]", "[0, 0, 1]"), blue = picture("[0, 0, 1]", "[1, 0, 0]");
      EXPECT_GT(red.at(4, 4, 0) - blue.at(4, 4, 0), 5.0f / 255) << "at " << near;
      EXPECT_GT(blue.at(4, 4, 2) - red.at(4, 4, 2), 5.0f / 255) << "at " << near;
    });
  }
}

TEST(TransparencyTechniques, StayFiniteForOpaqueCoincidentAndManyLayers) {
  std::vector<Sheet> list = sheets::shuffled(10, 11);
  for (int i = 0; i < 4; ++i) list.push_back({0.25f, {0.2f, 0.9f, 0.1f}, i % 2 ? 1.0f : 0.5f});
  Scene scene({9, 9});
  sheets::add(scene, list);
  for_each_technique(scene, [&](const std::string&) {
    const Pixels pixels = scene.layer("transparent");
    for (int c = 0; c < 4; ++c) {
      EXPECT_GE(pixels.at(4, 4, c), 0);
      EXPECT_LE(pixels.at(4, 4, c), 1 + 1e-4f);
    }
    EXPECT_NEAR(pixels.at(4, 4, 3), 1, 1e-4f);
  });
}

TEST(TransparencyTechniques, AreHiddenByOpaqueSurfaces) {
  Scene scene({9, 9});
  sheets::add(scene, sheets::shuffled(5, 2));
  scene.surface("wall", lumen::testing::moved(*lumen::testing::rectangle(3, 3), {0, 0, 2}), R"({"ambient": "ambient", "ambient_color": [0, 1, 0]})");
  for_each_technique(scene, [&](const std::string&) {
    EXPECT_NEAR(scene.layer("color").at(4, 4, 1), 1, 1e-6f);
    EXPECT_EQ(scene.layer("opacity").at(4, 4), 0);
  });
}

TEST(TransparencyTechniques, AverageOverTheSamplesOfAPixel) {
  Scene scene({16, 16});
  scene.add("ambient.constant", "ambient");
  scene.add("opacity.constant", "alpha", R"({"alpha": 0.5})");
  const float edge = 2.2f / 16 * 0.5f;  // in the middle of a column of pixels
  for (const char* id : {"near_sheet", "far_sheet"})
    scene.surface(id, lumen::testing::moved(*lumen::testing::rectangle(2, 4), {edge - 1, 0, *id == 'n' ? 0.0f : -0.5f}),
                  R"({"ambient": "ambient", "opacity": "alpha", "ambient_color": [1, 0, 0]})");
  scene.set("main.antialiasing", "16");
  for_each_technique(scene, [&](const std::string&) {
    const Pixels color = scene.layer("color");
    EXPECT_NEAR(color.at(7, 8, 0), 0.75f, 1e-3f);
    EXPECT_NEAR(color.at(8, 8, 0), 0.375f, 0.06f);
    EXPECT_NEAR(color.at(9, 8, 0), 0, 1e-6f);
  });
}

TEST(TransparencyTechniques, FollowAResizedPictureAndAChangedProperty) {
  Scene scene({9, 9});
  sheets::add(scene, {{0, {1, 0, 0}, 0.5f}});
  for_each_technique(scene, [&](const std::string& technique) {
    scene.resize({9, 9});
    scene.set("alpha0.alpha", "0.5");
    EXPECT_NEAR(scene.layer("transparent").at(4, 4, 0), 0.5f, 1e-4f);
    scene.resize({20, 17});
    scene.set("alpha0.alpha", "0.25");
    const Pixels pixels = scene.layer("transparent");
    for (const auto& [x, y] : {std::pair(0, 0), std::pair(19, 16)}) EXPECT_NEAR(pixels.at(x, y, 3), 0.25f, 1e-4f);
    scene.set(technique + ".enabled", "false");
    scene.layer("color");
    scene.set(technique + ".enabled", "true");
    EXPECT_NEAR(scene.layer("transparent").at(10, 8, 0), 0.25f, 1e-4f);
  });
}

/// Only the part of the picture where they can be is drawn: what they leave must be empty again, and what they enter, drawn.
TEST(TransparencyTechniques, LeaveNothingBehindWhereTheyWere) {
  const auto set_place = [](Scene& scene, float x) { scene.set("sheet0.transform", fmt::format("[0.2,0,0,{}, 0,0.2,0,0, 0,0,1,0, 0,0,0,1]", x)); };
  constexpr float left = -2.5f, right = 2.5f;
  Scene scene({400, 120});  // more than the margin apart
  sheets::add(scene, {{0, {1, 0, 0}, 0.5f}});
  for_each_technique(scene, [&](const std::string&) {
    for (const float x : {left, right}) {
      set_place(scene, x);
      const Pixels pixels = scene.layer("transparent");
      const int here = x == left ? 64 : 336;
      EXPECT_NEAR(pixels.at(here, 60, 3), 0.5f, 1e-4f);
      for (const int elsewhere : {0, 200, 399 - here, 399}) EXPECT_EQ(pixels.at(elsewhere, 60, 3), 0) << elsewhere << " at " << x;
    }
  });
}

TEST(TransparencyTechniques, ShowNothingOfAnOpaqueSurfaceThatIsGone) {
  Scene scene({9, 9});
  sheets::add(scene, {{0, {1, 0, 0}, 0.5f}});
  scene.surface("wall", lumen::testing::moved(*lumen::testing::rectangle(3, 3), {0, 0, -1}), R"({"ambient": "ambient", "ambient_color": [0, 1, 0]})");
  for_each_technique(scene, [&](const std::string&) {
    scene.set("wall.enabled", "true");
    EXPECT_NEAR(scene.layer("color").at(4, 4, 1), 0.5f, 1e-4f);
    scene.set("wall.enabled", "false");
    const Pixels color = scene.layer("color");
    EXPECT_EQ(color.at(4, 4, 1), 0);
    EXPECT_NEAR(color.at(4, 4, 0), 0.5f, 1e-4f);
    EXPECT_NEAR(color.at(4, 4, 3), 0.5f, 1e-4f);
    EXPECT_TRUE(std::isinf(scene.layer("depth").at(4, 4)));
  });
}

}  // namespace
