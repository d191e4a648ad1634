/// filter.normals: closed forms on cubes and spheres.
#include <cmath>
#include <map>
#include <numbers>

#include <glm/geometric.hpp>
#include <lumen/mesh.h>

#include "plugins/data_session.h"

namespace lumenshop {
namespace {

/// The cube -1..1 with 8 shared corners, a point array that is each point's number, and a cell array.
std::shared_ptr<lumen::Mesh> cube() {
  auto mesh = std::make_shared<lumen::Mesh>();
  std::vector<glm::vec3> positions;
  std::vector<float> numbers, cells;
  for (int corner = 0; corner < 8; ++corner) {
    positions.emplace_back(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    numbers.push_back(static_cast<float>(corner));
  }
  std::vector<glm::uvec3> triangles;
  const glm::uvec4 quads[] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const glm::uvec4& quad : quads) {
    triangles.emplace_back(quad.x, quad.y, quad.z);
    triangles.emplace_back(quad.x, quad.z, quad.w);
    cells.push_back(static_cast<float>(cells.size()));
    cells.push_back(static_cast<float>(cells.size()));
  }
  mesh->origin = "cube";
  mesh->positions = std::move(positions);
  mesh->triangles = std::move(triangles);
  mesh->attributes = {{"number", lumen::Attribute::On::points, 1, std::move(numbers)}, {"cell", lumen::Attribute::On::cells, 1, std::move(cells)}};
  mesh->finish();
  return mesh;
}

struct Filtered : DataSession {
  explicit Filtered(lumen::DataPointer input) {
    given("source", std::move(input));
    add("filter.normals", "smooth");
    session.link("smooth.mesh", "source.mesh");
  }
  std::shared_ptr<const lumen::Mesh> result() {
    run();
    return data<lumen::Mesh>("smooth.result");
  }
};

TEST(Normals, of_a_cube_with_creases_are_those_of_its_faces_exactly) {
  Filtered bench(cube());
  const auto result = bench.result();
  ASSERT_TRUE(result) << bench.messages("smooth");
  EXPECT_EQ(result->positions.size(), 24u);
  ASSERT_EQ(result->triangles.size(), 12u);
  for (const glm::uvec3& t : result->triangles) {
    const glm::vec3 face = glm::cross(result->positions[t.y] - result->positions[t.x], result->positions[t.z] - result->positions[t.x]) / 4.0f;
    for (int corner = 0; corner < 3; ++corner) EXPECT_EQ(result->normals[t[corner]], face);
  }
}

TEST(Normals, arrays_follow_the_doubled_points_and_cells_stay) {
  Filtered bench(cube());
  const auto result = bench.result();
  ASSERT_TRUE(result);
  const lumen::Attribute* number = result->attribute("number");
  ASSERT_TRUE(number);
  ASSERT_EQ(number->values.size(), 24u);
  for (std::size_t point = 0; point < 24; ++point) {
    const auto corner = static_cast<int>(number->values[point]);
    EXPECT_EQ(result->positions[point], glm::vec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1));
  }
  EXPECT_EQ(result->attribute("cell")->values.size(), 12u);
}

TEST(Normals, without_creases_a_cube_keeps_its_eight_points_and_weights_decide) {
  Filtered bench(cube());
  bench.session.set("smooth.crease", lumen::Value(180.0f));
  bench.session.set("smooth.weighting", lumen::Value(lumen::Choice{"angle"}));
  auto result = bench.result();
  ASSERT_TRUE(result);
  ASSERT_EQ(result->positions.size(), 8u);
  // Each face has 90 degrees at a corner, however it is cut: the diagonal.
  for (std::size_t point = 0; point < 8; ++point) EXPECT_NEAR(glm::distance(result->normals[point], glm::normalize(result->positions[point])), 0, 1e-6);

  bench.session.set("smooth.weighting", lumen::Value(lumen::Choice{"area"}));
  result = bench.result();
  // Corner 1 of the first and second triangle ... has (triangles of the faces -z, -y, +x) 1, 1 and 2 of them.
  std::map<int, glm::vec3> sums;
  for (const glm::uvec3& t : result->triangles)
    for (int corner = 0; corner < 3; ++corner)
      sums[static_cast<int>(t[corner])] += glm::cross(result->positions[t.y] - result->positions[t.x], result->positions[t.z] - result->positions[t.x]);
  for (const auto& [point, sum] : sums) EXPECT_NEAR(glm::distance(result->normals[static_cast<std::size_t>(point)], glm::normalize(sum)), 0, 1e-6);
}

TEST(Normals, a_fold_below_the_angle_stays_smooth_and_above_it_splits) {
  // Two squares that meet at the y axis, folded by 40 degrees.
  const float angle = 40 * std::numbers::pi_v<float> / 180;
  auto mesh = std::make_shared<lumen::Mesh>();
  mesh->positions = std::vector<glm::vec3>{{-1, 0, 0}, {0, 0, 0}, {std::cos(angle), 0, std::sin(angle)}, {-1, 1, 0}, {0, 1, 0}, {std::cos(angle), 1, std::sin(angle)}};
  mesh->triangles = std::vector<glm::uvec3>{{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
  mesh->finish();
  Filtered bench(mesh);
  bench.session.set("smooth.crease", lumen::Value(41.0f));
  EXPECT_EQ(bench.result()->positions.size(), 6u);
  bench.session.set("smooth.crease", lumen::Value(39.0f));
  const auto split = bench.result();
  EXPECT_EQ(split->positions.size(), 8u);
  EXPECT_EQ(split->normals[split->triangles[0].y], glm::vec3(0, 0, 1));
}

TEST(Normals, what_is_no_manifold_gets_averaged_normals_and_a_message) {
  auto mesh = std::make_shared<lumen::Mesh>();
  mesh->origin = "three leaves";
  mesh->positions = std::vector<glm::vec3>{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}};
  mesh->triangles = std::vector<glm::uvec3>{{0, 2, 1}, {0, 1, 3}, {0, 1, 4}};
  mesh->finish();
  Filtered bench(mesh);
  const auto result = bench.result();
  ASSERT_TRUE(result);
  EXPECT_EQ(result->positions.size(), 5u);
  EXPECT_EQ(result->normals.size(), 5u);
  EXPECT_NE(bench.messages("smooth").find("three leaves is no manifold"), std::string::npos) << bench.messages("smooth");
}

TEST(Normals, follows_a_phantom_of_its_own_normals) {
  DataSession bench;
  bench.add("importer.phantom", "phantom");
  bench.add("filter.normals", "smooth");
  bench.session.link("smooth.mesh", "phantom.lumen");
  bench.session.set("smooth.crease", lumen::Value(180.0f));
  bench.run();
  const auto source = bench.data<lumen::Mesh>("phantom.lumen"), result = bench.data<lumen::Mesh>("smooth.result");
  ASSERT_TRUE(result) << bench.messages("smooth");
  ASSERT_EQ(result->positions.size(), source->positions.size());
  double mean = 0;
  for (std::size_t point = 0; point < source->normals.size(); ++point) mean += glm::dot(source->normals[point], result->normals[point]);
  EXPECT_GT(mean / static_cast<double>(source->normals.size()), 0.995);
}

}  // namespace
}  // namespace lumenshop
