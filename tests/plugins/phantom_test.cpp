/// The generated dissection: counts, closedness, orientation, determinism.
#include <chrono>
#include <unordered_map>

#include <glm/geometric.hpp>
#include <lumen/mesh.h>

#include "plugins/closed_mesh.h"
#include "plugins/data_session.h"

namespace lumenshop {
namespace {

TEST(Phantom, has_the_triangles_that_were_asked_for_within_five_percent) {
  DataSession bench;
  bench.add("importer.phantom", "phantom");
  for (const int wanted : {1000, 5000, 100000, 300000}) {
    bench.session.set("phantom.triangles", lumen::Value(wanted));
    bench.run();
    const auto all = bench.data<lumen::Mesh>("phantom.mesh");
    ASSERT_TRUE(all) << bench.messages("phantom");
    EXPECT_NEAR(static_cast<double>(all->triangles.size()), wanted, 0.05 * wanted);
    EXPECT_EQ(all->triangles.size(), bench.data<lumen::Mesh>("phantom.wall")->triangles.size() + bench.data<lumen::Mesh>("phantom.lumen")->triangles.size() +
                                         bench.data<lumen::Mesh>("phantom.flap")->triangles.size());
  }
}

TEST(Phantom, parts_are_closed_and_oriented_outward_whatever_its_shape) {
  DataSession bench;
  bench.add("importer.phantom", "phantom");
  bench.session.set("phantom.triangles", lumen::Value(20000));
  const auto check = [&](const std::string& what) {
    bench.run();
    for (const char* part : {"phantom.wall", "phantom.lumen", "phantom.flap", "phantom.mesh"}) {
      const auto mesh = bench.data<lumen::Mesh>(part);
      ASSERT_TRUE(mesh) << what << bench.messages("phantom");
      EXPECT_EQ(open_edges(*mesh), 0u) << part << " " << what;
      EXPECT_GT(volume(*mesh), 0) << part << " " << what;
    }
    EXPECT_LT(volume(*bench.data<lumen::Mesh>("phantom.lumen")), volume(*bench.data<lumen::Mesh>("phantom.wall"))) << what;
  };
  check("as it comes");
  bench.session.set("phantom.bend", lumen::Value(0.0f));
  check("straight");
  bench.session.set("phantom.twist", lumen::Value(-2.0f));
  bench.session.set("phantom.tear", lumen::Value(40.0f));
  bench.session.set("phantom.irregularity", lumen::Value(0.1f));
  check("at the ends of its ranges");
  bench.session.set("phantom.branches", lumen::Value(false));
  bench.session.set("phantom.tear", lumen::Value(0.0f));
  bench.session.set("phantom.false_lumen", lumen::Value(0.85f));
  check("without branches and tears");
}

TEST(Phantom, a_straight_vessel_has_the_normals_of_its_rings) {
  DataSession bench;
  bench.add("importer.phantom", "phantom");
  for (const char* setting : {"phantom.bend", "phantom.irregularity"}) bench.session.set(setting, lumen::Value(0.0f));
  bench.session.set("phantom.branches", lumen::Value(false));
  bench.run();
  const auto wall = bench.data<lumen::Mesh>("phantom.wall");
  ASSERT_TRUE(wall);
  int checked = 0;
  for (std::size_t point = 0; point < wall->positions.size(); ++point) {
    const glm::vec3 position = wall->positions[point];
    // The healthy ascending part: a circular cone of slowly changing radius around the z axis.
    const float top = wall->bounds().max.z;
    if (position.z > top - 20 || position.z < top - 60) continue;
    const glm::vec3 radial = glm::normalize(glm::vec3(position.x, position.y, 0));
    ASSERT_GT(glm::dot(radial, wall->normals[point]), 0.99f) << "at " << position.x << " " << position.y << " " << position.z << " of " << top;
    ++checked;
  }
  EXPECT_GT(checked, 1000);
}

TEST(Phantom, the_same_seed_gives_the_same_vessel_and_another_seed_another) {
  DataSession bench;
  for (const char* id : {"a", "b", "c"}) {
    bench.add("importer.phantom", id);
    bench.session.set(std::string(id) + ".triangles", lumen::Value(5000));
  }
  bench.session.set("c.seed", lumen::Value(7));
  bench.run();
  const auto a = bench.data<lumen::Mesh>("a.mesh"), b = bench.data<lumen::Mesh>("b.mesh"), c = bench.data<lumen::Mesh>("c.mesh");
  ASSERT_TRUE(a && b && c);
  ASSERT_EQ(a->positions.size(), b->positions.size());
  EXPECT_TRUE(std::equal(a->positions.begin(), a->positions.end(), b->positions.begin()));
  EXPECT_NE(a->positions[100], c->positions[100]);
}

TEST(Phantom, names_its_parts_per_triangle) {
  DataSession bench;
  bench.add("importer.phantom", "phantom");
  bench.run();
  const auto all = bench.data<lumen::Mesh>("phantom.mesh");
  ASSERT_TRUE(all);
  const lumen::Attribute* part = all->attribute("part");
  ASSERT_TRUE(part);
  EXPECT_EQ(part->on, lumen::Attribute::On::cells);
  const auto walls = static_cast<std::size_t>(std::count(part->values.begin(), part->values.end(), 0.0f));
  EXPECT_EQ(walls, bench.data<lumen::Mesh>("phantom.wall")->triangles.size());
  ASSERT_TRUE(all->attribute("radius"));
  ASSERT_TRUE(all->attribute("pressure"));
}

}  // namespace
}  // namespace lumenshop
