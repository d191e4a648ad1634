/// filter.parts: thickness and seams against closed forms, whatever the scale and the way triangles face.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <lumen/components.h>
#include <lumen/testing.h>

#include "plugins/data_session.h"
#include "plugins/solids_of_revolution.h"

namespace lumenshop {
namespace {

using lumen::Mesh;
using MeshPointer = std::shared_ptr<const Mesh>;

struct Parts : DataSession {
  Parts() { add("filter.parts", "parts"); }
  explicit Parts(lumen::DataPointer input) : Parts() {
    given("source", std::move(input));
    session.link("parts.mesh", "source.mesh");
  }
  template <class T> void set(const std::string& property, T value) { session.set("parts." + property, lumen::Value(std::move(value))); }
  MeshPointer result() {
    run();
    return data<Mesh>("parts.result");
  }
  std::string messages() { return DataSession::messages("parts"); }
};

std::vector<float> numbers_of(const Mesh& mesh) {
  const lumen::Attribute* part = mesh.attribute(lumen::part_array);
  return part == nullptr ? std::vector<float>{} : std::vector<float>(part->values.begin(), part->values.end());
}
std::vector<float> thickness_of(const Mesh& mesh) {
  const lumen::Attribute* thickness = mesh.attribute("thickness");
  return thickness == nullptr ? std::vector<float>{} : std::vector<float>(thickness->values.begin(), thickness->values.end());
}
glm::vec3 center(const Mesh& mesh, std::size_t triangle) {
  const glm::uvec3& t = mesh.triangles[triangle];
  return (mesh.positions[t.x] + mesh.positions[t.y] + mesh.positions[t.z]) / 3.0f;
}
lumen::Bounds bounds_of(const Mesh& mesh, float part) {
  lumen::Bounds bounds;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    if (mesh.attribute(lumen::part_array)->values[i] == part)
      for (int k = 0; k < 3; ++k) bounds.include(mesh.positions[mesh.triangles[i][k]]);
  return bounds;
}
int count_of(const Mesh& mesh) {
  const std::vector<float> parts = numbers_of(mesh);
  return parts.empty() ? 0 : 1 + int(*std::max_element(parts.begin(), parts.end()));
}

std::shared_ptr<Mesh> with_triangles(const Mesh& mesh, std::vector<glm::uvec3> triangles) {
  auto result = std::make_shared<Mesh>();
  result->origin = mesh.origin;
  result->positions = mesh.positions;
  result->triangles = std::move(triangles);
  result->finish();
  return result;
}
std::shared_ptr<Mesh> scaled(const Mesh& mesh, float scale) {
  std::vector<glm::vec3> positions(mesh.positions.begin(), mesh.positions.end());
  for (glm::vec3& position : positions) position *= scale;
  auto result = std::make_shared<Mesh>();
  result->positions = std::move(positions);
  result->triangles = mesh.triangles;
  result->finish();
  return result;
}

TEST(Parts, ABallIsAsThickAsItsDiameterAndOnePart) {
  Parts bench(solids::ball(3));
  const MeshPointer result = bench.result();
  ASSERT_TRUE(result) << bench.messages();
  for (const float thickness : thickness_of(*result)) EXPECT_NEAR(thickness / 6, 1, 0.02);
  EXPECT_EQ(count_of(*result), 1);
  EXPECT_EQ(bench.messages(), "");
}

TEST(Parts, ABoxOfSixSeparateFacesIsOne) {
  Parts bench(lumen::testing::box());
  const MeshPointer result = bench.result();
  ASSERT_TRUE(result) << bench.messages();
  EXPECT_EQ(count_of(*result), 1);
  EXPECT_EQ(bench.messages(), "") << "points at the same place close it";
}

TEST(Parts, ATubeIsAsThickAsItsDiameter) {
  Parts bench(solids::tube(0.5, 8));
  const MeshPointer result = bench.result();
  ASSERT_TRUE(result) << bench.messages();
  const std::vector<float> thickness = thickness_of(*result);
  int seen = 0;
  for (std::size_t i = 0; i < thickness.size(); ++i)
    if (const float z = result->positions[i].z; z > 1.5f && z < 6.5f) {
      EXPECT_NEAR(thickness[i], 1, 0.06) << "z = " << z;
      ++seen;
    }
  EXPECT_GT(seen, 1000);
}

TEST(Parts, AHollowBallIsAsThickAsItsWall) {
  const MeshPointer inner = solids::ball(0.9);
  std::vector<glm::uvec3> turned(inner->triangles.begin(), inner->triangles.end());
  for (glm::uvec3& t : turned) std::swap(t.y, t.z);
  Parts bench(lumen::testing::joined({solids::ball(1), with_triangles(*inner, turned)}));
  bench.set("cone", 20.0f);
  const MeshPointer result = bench.result();
  ASSERT_TRUE(result) << bench.messages();
  for (const float thickness : thickness_of(*result)) EXPECT_NEAR(thickness, 0.1, 0.01);
}

TEST(Parts, ABallAndItsTubeMeetWhereTheyCross) {
  for (const double radius : {0.1, 0.2, 0.4}) {
    Parts bench(solids::ball_on_tube(radius));
    const MeshPointer result = bench.result();
    ASSERT_TRUE(result) << bench.messages();
    ASSERT_EQ(count_of(*result), 2) << "tube of radius " << radius;
    const double seam = std::sqrt(1 - radius * radius);
    EXPECT_NEAR(bounds_of(*result, 0).max.z, seam, 0.05) << "the ball is the larger part, tube of radius " << radius;
    EXPECT_NEAR(bounds_of(*result, 1).min.z, seam, 0.05);
    EXPECT_EQ(bounds_of(*result, 1).max.z, 4);
    EXPECT_EQ(lumen::parts_of(*result).count, 2u) << "what all tools go by";
  }
}

TEST(Parts, ADumbbellHasThreeNumberedBySize) {
  Parts bench(solids::dumbbell());
  const MeshPointer result = bench.result();
  ASSERT_TRUE(result) << bench.messages();
  ASSERT_EQ(count_of(*result), 3);
  EXPECT_NEAR(bounds_of(*result, 0).max.z, std::sqrt(0.96), 0.05);
  EXPECT_NEAR(bounds_of(*result, 1).min.z, 4 - std::sqrt(0.45), 0.05) << "the smaller ball has more area than the tube";
  EXPECT_NEAR(bounds_of(*result, 2).min.z, std::sqrt(0.96), 0.05);
}

TEST(Parts, AGivenThresholdDecides) {
  Parts bench(solids::dumbbell());
  bench.set("threshold", 1.7f);  // between the balls
  const MeshPointer result = bench.result();
  ASSERT_TRUE(result) << bench.messages();
  ASSERT_EQ(count_of(*result), 2);
  EXPECT_NEAR(bounds_of(*result, 0).max.z, std::sqrt(0.96), 0.05);
  EXPECT_NEAR(bounds_of(*result, 1).max.z, 4.7, 1e-3) << "the small ball is thin, as its tube";
  bench.set("threshold", 0.01f);
  EXPECT_EQ(count_of(*bench.result()), 1);
}

TEST(Parts, AreTheSameAtAnyScale) {
  const auto source = solids::ball_on_tube();
  const std::vector<float> expected = numbers_of(*Parts(source).result()), thickness = thickness_of(*Parts(source).result());
  for (const float scale : {1.0f / 1048576, 1048576.0f}) {
    const MeshPointer result = Parts(scaled(*source, scale)).result();
    ASSERT_TRUE(result);
    EXPECT_EQ(numbers_of(*result), expected) << scale;
    const std::vector<float> now = thickness_of(*result);
    for (std::size_t i = 0; i < now.size(); ++i) EXPECT_NEAR(now[i] / scale, thickness[i], 1e-3 * thickness[i]);
  }
}

TEST(Parts, AreTheSameHoweverTrianglesFace) {
  const auto source = solids::ball_on_tube();
  const MeshPointer expected = Parts(source).result();
  ASSERT_TRUE(expected);
  std::mt19937 random(1);
  for (const bool all : {true, false}) {
    std::vector<glm::uvec3> triangles(source->triangles.begin(), source->triangles.end());
    for (glm::uvec3& t : triangles)
      if (all || random() % 2 == 0) std::swap(t.y, t.z);
    Parts bench(with_triangles(*source, triangles));
    const MeshPointer result = bench.result();
    ASSERT_TRUE(result) << bench.messages();
    EXPECT_EQ(numbers_of(*result), numbers_of(*expected));
    const std::vector<float> now = thickness_of(*result), before = thickness_of(*expected);
    for (std::size_t i = 0; i < now.size(); ++i) EXPECT_NEAR(now[i], before[i], 1e-3f);
    EXPECT_EQ(bench.messages(), "");
  }
}

TEST(Parts, AreTheSameFromAFewSamples) {
  Parts bench(solids::ball_on_tube(0.2, 4, 120));
  bench.set("samples", 2000);
  const MeshPointer result = bench.result();
  ASSERT_TRUE(result) << bench.messages();
  EXPECT_GT(result->triangles.size(), 20000u);
  ASSERT_EQ(count_of(*result), 2);
  EXPECT_NEAR(bounds_of(*result, 0).max.z, std::sqrt(0.96), 0.05);
  EXPECT_NEAR(bounds_of(*result, 1).min.z, std::sqrt(0.96), 0.05);
}

TEST(Parts, SpecksStayOrJoinTheNearestPartOrAreTheLast) {
  const MeshPointer body = solids::ball_on_tube(), speck = solids::ball(0.02, 8);
  const auto first = float(body->triangles.size()), second = first + float(speck->triangles.size());
  Parts bench(lumen::testing::joined({solids::ball_on_tube(), lumen::testing::moved(*speck, {0.5f, 0, 3}), lumen::testing::moved(*speck, {0, 0, -1.5f})}));
  const auto numbers = [&](const char* specks) {
    bench.set("specks", lumen::Choice{specks});
    const MeshPointer result = bench.result();
    const std::vector<float> parts = numbers_of(*result);
    return std::array{float(count_of(*result)), parts[std::size_t(first)], parts[std::size_t(second)]};
  };
  EXPECT_EQ(numbers("join"), (std::array{2.0f, 1.0f, 0.0f})) << "one beside the tube, one below the ball";
  EXPECT_EQ(numbers("last"), (std::array{3.0f, 2.0f, 2.0f}));
  EXPECT_EQ(numbers("keep")[0], 4);
}

TEST(Parts, ConnectedOnesAreNumberedBySize) {
  using lumen::testing::moved;
  const auto ball = [](float radius, float x) { return moved(*solids::ball(radius, 16), {x, 0, 0}); };
  Parts bench(lumen::testing::joined({ball(0.5f, 0), ball(1, 5), ball(0.02f, 6.5f)}));
  bench.set("by", lumen::Choice{"connected"});
  const MeshPointer result = bench.result();
  ASSERT_TRUE(result) << bench.messages();
  ASSERT_EQ(count_of(*result), 2);
  EXPECT_NEAR(bounds_of(*result, 1).max.x, 0.5, 1e-6);
  EXPECT_NEAR(bounds_of(*result, 0).max.x, 6.52, 1e-5) << "the speck is of the nearer ball";
  EXPECT_EQ(result->attribute("thickness"), nullptr);
}

TEST(Parts, PolygonsStayWhole) {
  const auto source = solids::ball_on_tube();
  auto polygons = with_triangles(*source, {source->triangles.begin(), source->triangles.end()});
  std::vector<std::uint32_t> cells;
  for (std::uint32_t i = 0; i < source->triangles.size(); ++i) cells.push_back(i / 2);
  polygons->triangle_cells = cells;
  polygons->attributes = {{"label", lumen::Attribute::On::cells, 1, std::vector<float>(cells.back() + 1, 7.0f)}};
  polygons->finish();
  Parts bench(polygons);
  const MeshPointer result = bench.result();
  ASSERT_TRUE(result) << bench.messages();
  EXPECT_EQ(result->attribute(lumen::part_array)->values.size(), cells.back() + 1);
  EXPECT_EQ(count_of(*result), 2);
  EXPECT_EQ(result->attribute("label")->values[0], 7);
}

TEST(Parts, OfAnOpenMeshComeWithANote) {
  const auto source = solids::ball_on_tube();
  std::vector<glm::uvec3> open;
  for (std::size_t i = 0; i < source->triangles.size(); ++i)
    if (center(*source, i).z < 3.9f) open.push_back(source->triangles[i]);
  Parts bench(with_triangles(*source, open));
  const MeshPointer result = bench.result();
  ASSERT_TRUE(result) << bench.messages();
  EXPECT_EQ(count_of(*result), 2);
  EXPECT_NE(bench.messages().find("'turned' is open (80 border edges)"), std::string::npos) << bench.messages();

  Parts flat(lumen::testing::rectangle());
  EXPECT_FALSE(flat.result());
  EXPECT_NE(flat.messages().find("encloses nothing"), std::string::npos) << flat.messages();
}

TEST(Parts, OfTheScannedVesselsAreTheAortaAndEachKidney) {
  const std::string file = LUMEN_TEST_DATA "/meshes/abdomen-kidneys-aorta-segmentation.vtp";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
  Parts bench;
  bench.add("importer.vtk", "scan");
  bench.session.set("scan.path", lumen::Value(lumen::Path{file}));
  bench.session.link("parts.mesh", "scan.mesh");
  const MeshPointer result = bench.result();
  ASSERT_TRUE(result) << bench.messages();
  ASSERT_EQ(count_of(*result), 5) << "two kidneys with their vessels, the aorta, the celiac and upper mesenteric arteries, the lower one";
  const lumen::Bounds one = bounds_of(*result, 0), aorta = bounds_of(*result, 1), other = bounds_of(*result, 3);
  // Kidneys are 9 to 12 cm long, and lie on either side.
  EXPECT_NEAR(one.max.z - one.min.z, 110, 8);
  EXPECT_NEAR(other.max.z - other.min.z, 98, 8);
  EXPECT_GT(one.min.x, aorta.center().x);
  EXPECT_LT(other.max.x, aorta.center().x);
  EXPECT_NEAR(aorta.max.z - aorta.min.z, 226, 5) << "from end to end";
}

}  // namespace
}  // namespace lumenshop
