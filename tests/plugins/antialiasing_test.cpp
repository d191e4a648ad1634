/// Antialiasing: how close silhouettes come to their exact coverage, and that the ways to the same picture agree.
#include <cmath>
#include <map>
#include <vector>

#include <gtest/gtest.h>
#include <lumen/testing.h>

namespace {

using lumen::testing::Pixels;
using lumen::testing::Scene;

constexpr int size = 48;
constexpr float view_height = 2.2f, half_side = 0.7f;

/// The part of each pixel that lies in a square turned by `angle` about the origin, from 24 x 24 points.
std::vector<double> exact_coverage(float angle) {
  constexpr int points = 24;
  const float c = std::cos(angle), s = std::sin(angle);
  std::vector<double> coverage(size * size, 0.0);
  for (int j = 0; j < size * points; ++j)
    for (int i = 0; i < size * points; ++i) {
      const float u = view_height * ((float(i) + 0.5f) / (size * points) - 0.5f), v = view_height * (0.5f - (float(j) + 0.5f) / (size * points));
      if (std::abs(c * u + s * v) <= half_side && std::abs(c * v - s * u) <= half_side) coverage[std::size_t(j / points * size + i / points)] += 1.0 / (points * points);
    }
  return coverage;
}

/// Alpha minus coverage over the pixels of the silhouettes of squares at several angles.
struct EdgeError {
  double squares = 0, sum = 0;
  int count = 0;
  double rms() const { return std::sqrt(squares / count); }
  double mean() const { return sum / count; }
};
std::map<int, EdgeError> edge_errors() {
  std::map<int, EdgeError> errors;
  Scene scene({size, size});
  scene.add("ambient.constant", "ambient");
  scene.surface("square", lumen::testing::rectangle(2 * half_side, 2 * half_side), R"({"ambient": "ambient"})");
  for (const float angle : {0.02f, 0.1f, 0.25f, 0.4f, 0.6f, 0.78f}) {
    const float c = std::cos(angle), s = std::sin(angle);
    const std::vector<double> coverage = exact_coverage(angle);
    scene.set_value("square.transform", glm::mat4(glm::vec4(c, s, 0, 0), glm::vec4(-s, c, 0, 0), glm::vec4(0, 0, 1, 0), glm::vec4(0, 0, 0, 1)));
    for (const int samples : {1, 4, 16}) {
      scene.set("main.antialiasing", std::to_string(samples));
      const Pixels picture = scene.picture();
      EdgeError& of = errors[samples];
      for (int i = 0; i < size * size; ++i) {
        const double exact = coverage[std::size_t(i)], error = picture.rgba(i % size, i / size).a - exact;
        if (exact < 1e-6 || exact > 1 - 1e-6) continue;
        of.squares += error * error;
        of.sum += error;
        ++of.count;
      }
    }
  }
  return errors;
}

// A pixel's coverage is uniform in 0..1 along an edge: one sample errs by sqrt(1/12) = 0.29, a grid of n x n by that / n along the axes
// and less elsewhere; the rotated grid of 16 has 8 levels along the axes.
TEST(Antialiasing, MoreSamplesComeCloserToTheCoverage) {
  auto errors = edge_errors();
  EXPECT_NEAR(errors[1].rms(), 0.28, 0.04);
  EXPECT_LT(errors[4].rms(), 0.13);
  EXPECT_LT(errors[16].rms(), 0.05);
  EXPECT_NEAR(errors[4].mean(), 0, 0.02);
  EXPECT_NEAR(errors[16].mean(), 0, 0.02);
}

void add_lit_sphere(Scene& scene) {
  scene.add("ambient.constant", "ambient");
  scene.add("diffuse.lambert", "lambert");
  scene.surface("floor", lumen::testing::moved(*lumen::testing::rectangle(2, 2), {0, 0, -0.5f}), R"({"ambient": "ambient", "diffuse": "lambert", "ambient_color": [0.5, 0.5, 0.5]})");
  scene.surface("ball", lumen::testing::sphere(64, 0.6f), R"({"ambient": "ambient", "diffuse": "lambert", "ambient_color": [0.5, 0.5, 0.5]})");
}

TEST(Antialiasing, AfterAChangeOfLightThePictureIsThatOfAFreshView) {
  Scene changed({64, 64}), fresh({64, 64});
  for (Scene* scene : {&changed, &fresh}) {
    add_lit_sphere(*scene);
    scene->set("main.antialiasing", "4");
  }
  changed.layer("depth");  // the centers are drawn, too
  for (Scene* scene : {&changed, &fresh}) scene->set("front.color", "[1, 0.2, 0.1]");
  fresh.layer("depth");
  EXPECT_GT(fresh.picture().rgb(32, 32).r, 0.5f);
  EXPECT_EQ(lumen::testing::largest_difference(changed.picture(), fresh.picture()), 0);
}

// Where somebody asks for more than the picture, the pixels' centers are drawn, too, and give the occlusion.
TEST(Antialiasing, ThePictureIsTheSameWhetherOrNotTheCentersAreWanted) {
  for (const bool occluded : {false, true}) {
    Scene alone({64, 64}), beside({64, 64});
    for (Scene* scene : {&alone, &beside}) {
      add_lit_sphere(*scene);
      if (occluded) scene->add("occlusion.ssao", "ssao", R"({"radius": 0.3})");
      scene->set("main.antialiasing", "4");
    }
    beside.layer("depth");
    const Pixels a = alone.picture(), b = beside.picture();
    double sum = 0;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        EXPECT_NEAR(a.rgba(x, y).a, b.rgba(x, y).a, 1e-5f);
        sum += std::abs(a.at(x, y) - b.at(x, y));
      }
    if (occluded) {
      EXPECT_GT(sum, 0) << "the occlusion is that of another point of the pixel";
      EXPECT_LT(sum / (64 * 64), 0.004);
    } else {
      EXPECT_LT(lumen::testing::largest_difference(a, b), 1e-5f);
    }
  }
}

TEST(Antialiasing, ThePictureAloneDrawsSurfacesOnceAWindow) {
  Scene scene({64, 64});
  add_lit_sphere(scene);
  scene.add("occlusion.ssao", "ssao");
  scene.add("compositor.vignette", "vignette");
  scene.set("main.antialiasing", "4");
  scene.picture();
  EXPECT_EQ(scene.runs("geometry"), 1);
  EXPECT_EQ(scene.runs("ssao"), 1);
  scene.set("vignette.radius", "0.5");
  scene.picture();
  EXPECT_EQ(scene.runs("geometry"), 1);
  EXPECT_EQ(scene.runs("vignette"), 2);
  scene.set("ssao.radius", "0.1");
  scene.picture();
  EXPECT_EQ(scene.runs("ssao"), 2);
}

// Windows meet without a seam: a wall that fills a picture of several windows is even.
TEST(Antialiasing, WindowsMeetWithoutASeam) {
  Scene scene({640, 480});
  scene.add("ambient.constant", "ambient");
  scene.surface("wall", lumen::testing::rectangle(8, 8), R"({"ambient": "ambient", "ambient_color": [0.25, 0.5, 0.75]})");
  scene.set("main.antialiasing", "4");
  const Pixels picture = scene.picture();
  EXPECT_GT(scene.runs("geometry"), 1);
  float largest = 0;
  for (int y = 0; y < 480; ++y)
    for (int x = 0; x < 640; ++x) largest = std::max(largest, std::abs(picture.rgba(x, y).a - 1) + std::abs(picture.at(x, y, 1) - 0.5f));
  EXPECT_LT(largest, 1e-5f);
}

}  // namespace
