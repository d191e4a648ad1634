/// transparency.mlab, transparency.front_weighted and transparency.moments: exact where they must be, and how far off elsewhere.

#include <set>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "transparent_sheets.h"

namespace {

using sheets::Pixels;
using sheets::Scene;
using sheets::Sheet;

float error_of(const std::string& technique, const std::string& properties, const std::vector<Sheet>& list, glm::ivec2 size = {9, 9}) {
  Scene scene(size);
  scene.add(technique, "technique", properties);
  sheets::add(scene, list);
  const float error = sheets::largest_error(scene, list);
  for (const lumen::Problem& problem : scene.problems()) ADD_FAILURE() << problem.message;
  return error;
}

TEST(Mlab, IsExactForAsManyLayersAsItHasNodes) {
  for (const int layers : {1, 2, 5, 8}) {
    const auto list = sheets::shuffled(layers, 3);
    Scene scene({9, 9});
    scene.add("transparency.mlab", "technique");
    sheets::add(scene, list);
    for (const char* merge : {"sum", "over"})
      for (const int nodes : std::set{layers, 8}) {
        scene.set("technique.merge", merge);
        scene.set("technique.nodes", std::to_string(nodes));
        EXPECT_LT(sheets::largest_error(scene, list), 1e-4f) << layers << " layers, " << nodes << " nodes, " << merge;
      }
  }
}

TEST(Mlab, IsOffByNoMoreThanWhatTheNodesLetThrough) {
  for (const int layers : {3, 9, 20}) {
    const auto list = sheets::shuffled(layers, unsigned(layers), 0.6f);
    Scene scene({9, 9});
    scene.add("transparency.mlab", "technique");
    sheets::add(scene, list);
    std::vector<Sheet> sorted = list;
    std::sort(sorted.begin(), sorted.end(), [](const Sheet& a, const Sheet& b) { return a.height > b.height; });
    float through = 1;
    for (int nodes = 1; nodes <= 8 && nodes < layers; ++nodes) {
      through *= 1 - sorted[std::size_t(nodes - 1)].alpha;
      if (nodes != 1 && nodes != 2 && nodes != 5 && nodes != 8) continue;  // each number is a program of its own
      scene.set("technique.nodes", std::to_string(nodes));
      EXPECT_LT(sheets::largest_error(scene, list), through * 0.5f + 1e-4f) << layers << " layers, " << nodes << " nodes";
    }
  }
}

TEST(Mlab, MergingAsInThePaperKeepsTheOpacityAndIsBounded) {
  const auto list = sheets::shuffled(12, 8, 0.5f);
  EXPECT_LT(error_of("transparency.mlab", R"({"nodes": 8, "merge": "over"})", list), 0.1f);
}

TEST(FrontWeighted, IsExactForTwoLayers) {
  for (const unsigned seed : {1u, 2u, 3u}) EXPECT_LT(error_of("transparency.front_weighted", "{}", sheets::shuffled(2, seed)), 1e-4f);
  EXPECT_LT(error_of("transparency.front_weighted", "{}", {{0, {1, 0, 0}, 0.5f, {0.9f, 0.1f}}, {0.01f, {0, 1, 0}, 0.5f, {-0.7f, 0.3f}}}, {48, 48}), 1e-4f) << "intersecting";
}

TEST(FrontWeighted, IsWeightedBlendingBehindTheFront) {
  const float decay = 3;
  const std::vector<Sheet> list = {{-0.5f, {0, 0, 1}, 0.3f}, {0.5f, {1, 0, 0}, 0.4f}, {0, {0, 1, 0}, 0.6f}};
  Scene scene({9, 9});
  scene.add("transparency.front_weighted", "technique", R"({"decay": 3})");
  sheets::add(scene, list);
  const Pixels pixels = scene.layer("transparent");
  // The bounds' sphere: the box is 3 x 3 x 1, its center at distance 10.
  const float radius = 0.5f * std::sqrt(19.0f);
  const auto weight = [&](float z) { return std::exp(-decay * (radius - z) / (2 * radius)); };
  const float green = 0.6f * weight(0), blue = 0.3f * weight(-0.5f), opacity = 1 - 0.4f * 0.7f;
  EXPECT_NEAR(pixels.at(4, 4, 0), 0.4f, 1e-5f);
  EXPECT_NEAR(pixels.at(4, 4, 1), 0.6f * opacity * green / (green + blue), 1e-4f);
  EXPECT_NEAR(pixels.at(4, 4, 2), 0.6f * opacity * blue / (green + blue), 1e-4f);
}

TEST(Moments, ResolveAsManyLayersAsTheyHaveHalves) {
  // A distribution of n points is known by its first 2 n moments. What is left is the bias, and the fragment's own share.
  for (const int layers : {2, 3, 4}) {
    const auto list = sheets::shuffled(layers, unsigned(layers), 0.6f);
    Scene scene({9, 9});
    scene.add("transparency.moments", "technique", R"({"overestimation": 0})");
    sheets::add(scene, list);
    const int moments = 2 * layers;
    scene.set("technique.moments", '"' + std::to_string(moments) + '"');
    for (const char* bounds : {"surfaces", "pixel"}) {
      scene.set("technique.bounds", bounds);
      const float error = sheets::largest_error(scene, list);
      EXPECT_LT(error, 0.01f) << moments << " moments, " << layers << " layers, " << bounds;
      RecordProperty("error_" + std::to_string(moments) + "_" + std::to_string(layers) + "_" + bounds, std::to_string(error));
    }
  }
}

TEST(Moments, AreCloseToExactOnSmoothStacks) {
  // Colors that change slowly with depth, as in smoke: the approximation that the technique is made for.
  for (const auto& [moments, tolerance] : {std::pair(4, 0.03f), std::pair(6, 0.02f), std::pair(8, 0.015f)}) {
    std::vector<Sheet> list;
    for (int i = 0; i < 32; ++i) {
      const float at = float(i * 13 % 32) / 31;
      list.push_back({1 - 2 * at, {1 - at, 0.5f, at}, 0.06f});
    }
    for (const char* bounds : {"surfaces", "pixel"})
      EXPECT_LT(error_of("transparency.moments", fmt::format(R"({{"bounds": "{}", "moments": "{}"}})", bounds, moments), list), tolerance) << moments << ' ' << bounds;
  }
}

TEST(Moments, BeatPlainWeightsOnAverage) {
  Scene scene({1, 1});
  sheets::add(scene, sheets::shuffled(6, 1, 0.6f));
  const auto sum_of_errors = [&](const char* technique) {
    scene.add(technique, technique + std::string_view("transparency.").size());
    double sum = 0;
    for (unsigned seed = 1; seed <= 12; ++seed) {
      const auto list = sheets::shuffled(6, seed, 0.6f);
      for (std::size_t i = 0; i < list.size(); ++i) {
        const std::string number = std::to_string(i);
        scene.set("alpha" + number + ".alpha", sheets::text(list[i].alpha));
        scene.set("sheet" + number + ".ambient_color", sheets::text(list[i].color));
        scene.set("sheet" + number + ".transform", sheets::transform_of(list[i]));
      }
      sum += double(sheets::largest_error(scene, list));
    }
    return sum;
  };
  const double moments = sum_of_errors("transparency.moments"), weighted = sum_of_errors("transparency.weighted");
  EXPECT_LT(moments, 0.5 * weighted) << moments / 12 << " against " << weighted / 12;
}

TEST(Moments, AreSharpWhereAPixelsSurfacesLieCloseTogetherUnlessTheySpanAll) {
  auto list = sheets::shuffled(6, 5, 0.6f);
  for (Sheet& sheet : list) sheet.height *= 0.1f;  // all surfaces' sphere is some twenty times as deep
  Scene scene({9, 9});
  scene.add("transparency.moments", "technique");
  sheets::add(scene, list);
  const float by_default = sheets::largest_error(scene, list);
  scene.set("technique.bounds", "surfaces");
  EXPECT_LT(by_default, 0.5f * sheets::largest_error(scene, list));
}

TEST(Moments, TheBiasFollowsTheirNumberUnlessSet) {
  Scene scene({9, 9});
  scene.add("transparency.moments", "technique", R"({"moments": "4"})");
  sheets::add(scene, {{}});
  scene.layer("color");
  EXPECT_FLOAT_EQ(std::get<float>(scene.value("technique.bias")), 5e-7f);
  scene.set("technique.moments", R"("6")");
  scene.layer("color");
  EXPECT_FLOAT_EQ(std::get<float>(scene.value("technique.bias")), 5e-6f);
  scene.set("technique.bias", "0.001");
  scene.set("technique.moments", R"("8")");
  scene.layer("color");
  EXPECT_FLOAT_EQ(std::get<float>(scene.value("technique.bias")), 1e-3f);
}

}  // namespace
