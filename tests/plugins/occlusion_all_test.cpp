/// What every ambient occlusion that the installation has must hold to; a new one is covered by being there.

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "occluders.h"
#include "plugins/installed_types.h"

namespace {

using lumen::testing::Pixels;
using lumen::testing::Scene;

constexpr const char* turned_by_60 = R"({"transform": [1,0,0,0, 0,0.5,-0.8660254,0, 0,0.8660254,0.5,0, 0,0,0,1]})";

/// Of those that darken an ambient light, not those that give illumination.
std::vector<std::string> installed_occlusions() {
  std::vector<std::string> ids = lumenshop::installed_types(lumen::Kind::occlusion);
  std::erase_if(ids, [](const std::string& id) {
    Scene scene;
    const auto& writes = scene.add(id, "ao").writes();
    return std::none_of(writes.begin(), writes.end(), [](const lumen::Writes* layer) { return layer->layer() == "occlusion"; });
  });
  return ids;
}

bool has(const Scene& scene, const std::string& property) {
  try {
    scene.value(property);
    return true;
  } catch (const lumen::Error&) {
    return false;
  }
}

void set_if_there(Scene& scene, const std::string& property, const char* value) {
  if (has(scene, property)) scene.set(property, value);
}

/// Creases, a step and open background in one picture.
std::shared_ptr<lumen::Mesh> landscape() {
  return occluders::drawn_out({{-0.9f, 0.1f}, {-0.5f, -0.3f}, {-0.2f, 0.1f}, {0, 0.1f}, {0, -0.2f}, {0.5f, -0.2f}, {0.8f, 0.3f}}, 0.8f);
}

void add_landscape(Scene& scene, const std::string& type) {
  scene.surface("ground", landscape());
  scene.add(type, "ao");
  set_if_there(scene, "ao.refinements", "2");
}

float largest(const Pixels& layer) {
  float most = 0;
  for (int y = 0; y < layer.height(); ++y)
    for (int x = 0; x < layer.width(); ++x) most = std::max(most, std::isnan(layer.at(x, y)) ? 1e30f : std::abs(layer.at(x, y)));
  return most;
}

std::string texts(const std::vector<lumen::Problem>& problems) {
  std::string text;
  for (const lumen::Problem& problem : problems) text += problem.message + "; ";
  return text;
}

TEST(AllOcclusions, AreInstalled) {
  const std::vector<std::string> ids = installed_occlusions();
  for (const char* id : {"occlusion.ssao", "occlusion.hbao", "occlusion.gtao", "occlusion.bitmask", "occlusion.voxel", "occlusion.stochastic_depth"})
    EXPECT_NE(std::find(ids.begin(), ids.end(), id), ids.end()) << id;
}

/// The plane goes on beyond the picture: its edge is as open as its middle.
void expect_open(const std::string& type, const char* surface) {
  Scene scene({64, 64});
  scene.surface("wall", lumen::testing::rectangle(6, 6), surface);
  scene.add(type, "ao");
  set_if_there(scene, "ao.refinements", "2");
  for (const char* radius : {"0.02", "0.2", "1"})
    for (const char* projection : {"orthographic", "perspective"}) {
      set_if_there(scene, "ao.radius", radius);
      scene.set("camera.projection", projection);
      EXPECT_LE(largest(scene.layer("occlusion")), 1.0f / 255) << type << ", " << projection << ", radius " << radius;
    }
}

TEST(AllOcclusions, LeaveAPlaneThatFacesTheEyeOpen) {
  for (const std::string& type : installed_occlusions()) expect_open(type, "{}");
}

TEST(AllOcclusions, LeaveATiltedPlaneOpen) {
  for (const std::string& type : installed_occlusions()) expect_open(type, turned_by_60);
}

TEST(AllOcclusions, DarkenCreasesBetweenZeroAndOneAndNoBackground) {
  for (const std::string& type : installed_occlusions()) {
    Scene scene({96, 96});
    add_landscape(scene, type);
    set_if_there(scene, "ao.radius", "0.2");
    const Pixels layer = scene.layer("occlusion"), depth = scene.layer("depth");
    EXPECT_EQ(texts(scene.problems()), "") << type;
    for (int y = 0; y < layer.height(); ++y)
      for (int x = 0; x < layer.width(); ++x) {
        const float value = layer.at(x, y);
        ASSERT_TRUE(value >= 0 && value <= 1) << type << ": " << value << " at " << x << ", " << y;
        ASSERT_TRUE(value == 0 || std::isfinite(depth.at(x, y))) << type << ": background at " << x << ", " << y;
      }
    // The valley at x = -.5 against the ridge at x = -.1 .
    EXPECT_GT(occluders::mean(layer, 25, 40, 28, 56), 0.1f) << type;
    EXPECT_LT(occluders::mean(layer, 42, 40, 46, 56), 0.05f) << type;
  }
}

TEST(AllOcclusions, AreNotOccludedByTheBackground) {
  for (const std::string& type : installed_occlusions()) {
    Scene scene({96, 96});
    scene.surface("tile", lumen::testing::rectangle(1, 1), turned_by_60);
    scene.add(type, "ao");
    set_if_there(scene, "ao.radius", "1");
    EXPECT_LE(largest(scene.layer("occlusion")), 1.0f / 255) << type;
  }
}

TEST(AllOcclusions, GiveTheSamePictureTwice) {
  for (const std::string& type : installed_occlusions()) {
    Scene first({64, 64}), second({64, 64});
    add_landscape(first, type);
    add_landscape(second, type);
    EXPECT_EQ(lumen::testing::largest_difference(first.layer("occlusion"), second.layer("occlusion")), 0) << type;
  }
}

TEST(AllOcclusions, AreTheSameInTheMeanAtHalfResolution) {
  for (const std::string& type : installed_occlusions()) {
    Scene scene({95, 96});
    add_landscape(scene, type);
    if (!has(scene, "ao.half_resolution")) continue;
    const Pixels whole = scene.layer("occlusion");
    scene.set("ao.half_resolution", "true");
    const Pixels half = scene.layer("occlusion");
    double difference = 0;
    for (int y = 0; y < 96; ++y)
      for (int x = 0; x < 95; ++x) difference += double(std::abs(whole.at(x, y) - half.at(x, y)));
    EXPECT_LT(difference / (95 * 96), 0.05) << type;
    EXPECT_NEAR(occluders::mean(half, 0, 0, 95, 96), occluders::mean(whole, 0, 0, 95, 96), 0.01f) << type;
    EXPECT_GT(lumen::testing::largest_difference(whole, half), 0) << type;
    EXPECT_EQ(texts(scene.problems()), "") << type;
  }
}

/// How many pixels pass the depth test while a layer is drawn.
int visited(Scene& scene, const std::string& layer) {
  GLuint query = 0, count = 0;
  glGenQueries(1, &query);
  glBeginQuery(GL_SAMPLES_PASSED, query);
  scene.layer(layer);
  glEndQuery(GL_SAMPLES_PASSED);
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &count);
  glDeleteQueries(1, &query);
  return int(count);
}

TEST(AllOcclusions, VisitOnlyWhatIsCoveredAtHalfResolution) {
  constexpr int pixels = 256 * 256;
  for (const std::string& type : installed_occlusions()) {
    Scene scene({256, 256});
    scene.surface("tile", lumen::testing::rectangle(0.1f, 0.1f));
    scene.add(type, "ao");
    if (!has(scene, "ao.half_resolution")) continue;
    set_if_there(scene, "ao.refinements", "1");
    const int whole = visited(scene, "occlusion");
    scene.set("ao.half_resolution", "true");
    // A quarter of the picture to find out, and what is covered a few times.
    EXPECT_LT(visited(scene, "occlusion"), whole + pixels / 4 + pixels / 50) << type;
  }
}

/// A crease that runs out of the picture: what lies beyond the edge is unknown, and may cost at most what half the sky would.
TEST(AllOcclusions, ShowNoFrameAtThePictureEdge) {
  for (const std::string& type : installed_occlusions()) {
    Scene scene({96, 96});
    scene.surface("crease", occluders::drawn_out({{-1.6f, 1.6f}, {0, 0}, {1.6f, 1.6f}}, 1.6f));
    scene.add(type, "ao");
    set_if_there(scene, "ao.refinements", "2");
    const Pixels layer = scene.layer("occlusion");
    const float middle = occluders::mean(layer, 40, 40, 56, 56), top = occluders::mean(layer, 40, 0, 56, 2), bottom = occluders::mean(layer, 40, 94, 56, 96);
    EXPECT_NEAR(top, middle, 0.5f * middle) << type;
    EXPECT_NEAR(bottom, middle, 0.5f * middle) << type;
    EXPECT_LT(occluders::mean(layer, 0, 40, 2, 56), occluders::mean(layer, 24, 40, 26, 56) + 0.02f) << type;
  }
}

/// The mean of n refinements is that of their pictures: two more halve what they add, and the noise goes.
TEST(AllOcclusions, RefineTowardALimit) {
  for (const std::string& type : installed_occlusions()) {
    Scene scene({64, 64});
    add_landscape(scene, type);
    if (!has(scene, "ao.refinements")) continue;
    set_if_there(scene, "ao.blur", "false");
    const auto refined = [&](const char* refinements) {
      scene.set("ao.refinements", refinements);
      return scene.layer("occlusion");
    };
    const Pixels once = refined("1"), limit = refined("64"), often = refined("16");
    const auto deviation = [&](const Pixels& layer) {
      double sum = 0;
      for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) sum += double(std::abs(layer.at(x, y) - limit.at(x, y)));
      return sum;
    };
    EXPECT_LT(deviation(often), 0.5 * deviation(once)) << type;
    EXPECT_EQ(lumen::testing::largest_difference(once, refined("1")), 0) << type;
  }
}

}  // namespace
