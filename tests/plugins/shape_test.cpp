/// importer.shape: closed, turned outward, of the size that was asked for, with exact normals.
#include <cmath>
#include <numbers>

#include "plugins/closed_mesh.h"
#include "plugins/data_session.h"

namespace lumenshop {
namespace {

struct Shapes : testing::Test {
  DataSession bench;
  std::shared_ptr<const lumen::Mesh> mesh(const std::string& shape, int detail) {
    if (bench.session.find("shape") == nullptr) bench.add("importer.shape", "shape");
    bench.session.set("shape.shape", lumen::Value(lumen::Choice{shape}));
    bench.session.set("shape.detail", lumen::Value(detail));
    bench.session.set("shape.radius", lumen::Value(2.0f));
    bench.run();
    return bench.data<lumen::Mesh>("shape.mesh");
  }
};

TEST_F(Shapes, sphere_and_torus_are_closed_without_a_seam_and_fill_their_volume) {
  const auto sphere = mesh("sphere", 256), torus = mesh("torus", 256);
  ASSERT_TRUE(sphere && torus) << bench.messages("shape");
  EXPECT_EQ(open_edges(*sphere), 0u);
  EXPECT_EQ(open_edges(*torus), 0u);
  const double pi = std::numbers::pi;
  EXPECT_NEAR(volume(*sphere) / (4.0 / 3 * pi * 8), 1, 1e-3);
  EXPECT_NEAR(volume(*torus) / (2 * pi * pi * 1.4 * 0.36), 1, 2e-3) << "center circle 1.4, tube .6";
}

TEST_F(Shapes, beads_are_three_balls_on_a_tube) {
  const auto beads = mesh("beads", 256);
  ASSERT_TRUE(beads) << bench.messages("shape");
  EXPECT_EQ(open_edges(*beads), 0u);
  const double pi = std::numbers::pi, tube = 0.6;
  double expected = 0, length = 2 * 2.0;  // between the balls, then from fold to fold
  for (const auto& [radius, ends] : {std::pair(2.0, 1), std::pair(1.5, 2), std::pair(1.0, 1)}) {
    const double beyond = radius - std::sqrt(radius * radius - tube * tube);
    expected += 4.0 / 3 * pi * radius * radius * radius - ends * pi * beyond * beyond * (3 * radius - beyond) / 3;
    length += ends * beyond;
  }
  EXPECT_NEAR(volume(*beads) / (expected + pi * tube * tube * length), 1, 2e-3);
  EXPECT_NEAR(beads->bounds().max.z - beads->bounds().min.z, 13, 1e-5);
  EXPECT_NEAR(beads->bounds().center().z, 0, 1e-6);
  for (std::size_t i = 0; i < beads->positions.size(); ++i) EXPECT_NEAR(glm::length(beads->normals[i]), 1, 1e-6f);
}

TEST_F(Shapes, coarse_ones_are_still_closed) {
  for (const int detail : {1, 2, 3, 5})
    for (const char* shape : {"sphere", "torus", "beads"}) {
      const auto coarse = mesh(shape, detail);
      ASSERT_TRUE(coarse) << bench.messages("shape");
      EXPECT_EQ(open_edges(*coarse), 0u) << shape << " " << detail;
      EXPECT_GT(volume(*coarse), 0) << shape << " " << detail;
    }
}

TEST_F(Shapes, box_encloses_its_volume_and_all_normals_point_out) {
  EXPECT_NEAR(volume(*mesh("box", 3)), 64, 1e-3);
  for (const char* shape : {"sphere", "box"}) {
    const auto solid = mesh(shape, 8);
    for (std::size_t i = 0; i < solid->positions.size(); ++i) {
      EXPECT_NEAR(glm::length(solid->normals[i]), 1, 1e-6f);
      EXPECT_GT(glm::dot(solid->positions[i], solid->normals[i]), 1.9f) << shape;
    }
  }
}

TEST_F(Shapes, plane_faces_z) {
  const auto plane = mesh("plane", 4);
  EXPECT_EQ(plane->triangles.size(), 32u);
  EXPECT_EQ(plane->bounds().max, glm::vec3(2, 2, 0));
  for (const glm::vec3& normal : plane->normals) EXPECT_EQ(normal, glm::vec3(0, 0, 1));
}

}  // namespace
}  // namespace lumenshop
