/// finish() refuses what would crash a renderer, and computes what it promises.
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <lumen/error.h>
#include <lumen/image.h>
#include <lumen/lines.h>
#include <lumen/mesh.h>
#include <lumen/volume.h>

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

lumen::Mesh square() {
  lumen::Mesh mesh;
  mesh.origin = "square";
  mesh.positions = std::vector<glm::vec3>{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
  mesh.triangles = std::vector<glm::uvec3>{{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

template <class T> std::string refusal(T data) {
  try {
    data.finish();
  } catch (const lumen::Error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Mesh, finish_computes_bounds_and_accepts_what_is_well_formed) {
  lumen::Mesh mesh = square();
  mesh.attributes = {{"heat", lumen::Attribute::On::points, 1, std::vector<float>{1, nan, 3, 4}}, {"side", lumen::Attribute::On::cells, 2, std::vector<float>(4)}};
  mesh.finish();
  EXPECT_EQ(mesh.bounds().min, glm::vec3(0));
  EXPECT_EQ(mesh.bounds().max, glm::vec3(2, 1, 0));
  EXPECT_EQ(mesh.summary(), "2 triangles, 4 points");
  EXPECT_EQ(mesh.bytes(), 4u * 12 + 2 * 12 + 4 * 4 + 4 * 4);
  EXPECT_EQ(mesh.attribute("heat")->components, 1);
  EXPECT_FALSE(mesh.attribute("cold"));
}

TEST(Mesh, finish_names_the_origin_and_the_fault) {
  lumen::Mesh mesh = square();
  mesh.triangles = std::vector<glm::uvec3>{{0, 1, 2}, {0, 2, 4}};
  EXPECT_EQ(refusal(mesh), "square: a triangle names point 4; there are 4 (the first is 0)");
  mesh = square();
  mesh.positions = std::vector<glm::vec3>{{0, 0, 0}, {2, 0, 0}, {2, nan, 0}, {0, 1, 0}};
  EXPECT_EQ(refusal(mesh), "square: positions hold a number that is not finite (number 7)");
  mesh = square();
  mesh.normals = std::vector<glm::vec3>(3);
  EXPECT_EQ(refusal(mesh), "square: 3 normals for 4 points");
  mesh = square();
  mesh.triangle_cells = std::vector<std::uint32_t>{0, 9};
  mesh.attributes = {{"side", lumen::Attribute::On::cells, 1, std::vector<float>(9)}};
  EXPECT_EQ(refusal(mesh), "square: array 'side' has 9 numbers for 10 cells of 1 components");
  mesh = square();
  mesh.attributes = {{"many", lumen::Attribute::On::points, 17, std::vector<float>(68)}};
  EXPECT_NE(refusal(mesh).find("17 components"), std::string::npos);
}

TEST(Mesh, averaged_normals_weigh_by_area_at_any_scale) {
  for (const float scale : {1e-15f, 1.0f, 1e15f}) {
    // Two right triangles of area 2 and 1 that meet at a right angle along the x axis.
    const std::vector<glm::vec3> positions = {glm::vec3(0), glm::vec3(2, 0, 0) * scale, glm::vec3(0, 2, 0) * scale, glm::vec3(0, 0, -1) * scale};
    const std::vector<glm::uvec3> triangles = {{0, 1, 2}, {0, 3, 1}};
    const auto normals = lumen::average_normals(positions, triangles);
    EXPECT_EQ(normals[2], glm::vec3(0, 0, 1));
    EXPECT_NEAR(glm::distance(normals[0], glm::normalize(glm::vec3(0, -1, 2))), 0, 1e-6) << scale;
  }
}

TEST(Lines, offsets_are_checked) {
  lumen::Lines lines;
  lines.origin = "tracks";
  lines.positions = std::vector<glm::vec3>(4);
  lines.offsets = std::vector<std::uint32_t>{0, 3, 4};
  lines.finish();
  EXPECT_EQ(lines.count(), 2u);
  EXPECT_EQ(lines.line(1).size(), 1u);
  lines.offsets = std::vector<std::uint32_t>{0, 3, 2};
  EXPECT_EQ(refusal(lines), "tracks: line 1 ends before it begins");
  lines.offsets = std::vector<std::uint32_t>{0, 3, 5};
  EXPECT_EQ(refusal(lines), "tracks: the lines end at point 5 of 4");
  lines.offsets = {};
  EXPECT_NE(refusal(lines), "accepted");
}

TEST(Volume, range_and_box_come_from_finite_voxels_and_the_matrix) {
  lumen::Volume volume;
  volume.dimensions = {2, 1, 2};
  volume.voxels = lumen::Array<float>(std::vector<float>{3, nan, -1, 2});
  volume.to_object = glm::mat4(2);
  volume.to_object[3] = {10, 0, 0, 1};
  volume.finish();
  EXPECT_EQ(volume.value_range, glm::vec2(-1, 3));
  EXPECT_EQ(volume.bounds().min, glm::vec3(10, 0, 0));
  EXPECT_EQ(volume.bounds().max, glm::vec3(12, 0, 2));
  volume.to_object[0] = glm::vec4(0);
  EXPECT_NE(refusal(volume).find("not invertible"), std::string::npos);
  volume.to_object = glm::mat4(1);
  volume.dimensions = {2, 2, 2};
  EXPECT_NE(refusal(volume).find("4 numbers for 8 voxels"), std::string::npos) << refusal(volume);
}

TEST(Image, sizes_and_channel_names_are_checked) {
  lumen::Image image;
  image.width = 2;
  image.height = 2;
  image.channels = {"R", "R"};
  image.pixels = std::vector<float>(8);
  EXPECT_NE(refusal(image), "accepted");
  image.channels = {"R", "G"};
  EXPECT_EQ(refusal(image), "accepted");
  image.height = 3;
  EXPECT_NE(refusal(image), "accepted");
}

TEST(TransferFunction, is_linear_between_points_and_clamped_beyond) {
  lumen::TransferFunction function;
  EXPECT_EQ(function.at(0.5f), glm::vec4(1));
  function.points = {{1, {0, 0, 0, 0}}, {3, {1, 0.5f, 0, 1}}};
  EXPECT_EQ(function.at(2), glm::vec4(0.5f, 0.25f, 0, 0.5f));
  EXPECT_EQ(function.at(-5), glm::vec4(0));
  EXPECT_EQ(function.at(9), glm::vec4(1, 0.5f, 0, 1));
}

TEST(Numbers, are_grouped_by_thousands) {
  EXPECT_EQ(lumen::grouped(0), "0");
  EXPECT_EQ(lumen::grouped(999), "999");
  EXPECT_EQ(lumen::grouped(1234567), "1,234,567");
}

}  // namespace
