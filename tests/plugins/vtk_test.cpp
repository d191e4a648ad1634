/// importer.vtk and exporter.vtk through the helper process: real files, round trips, broken files.
#include <algorithm>
#include <array>
#include <fstream>
#include <limits>

#include <glm/geometric.hpp>
#include <lumen/lines.h>
#include <lumen/mesh.h>

#include "plugins/data_session.h"

namespace lumenshop {
namespace {

namespace files = std::filesystem;

struct Reader : DataSession {
  Reader() { add("importer.vtk", "scan"); }
  void read(const files::path& file) {
    session.set("scan.path", lumen::Value(lumen::Path{file.string()}));
    run();
  }
  void read_text(const std::string& name, const std::string& text) {
    std::ofstream(folder / name, std::ios::binary) << text;
    read(folder / name);
  }
  std::shared_ptr<const lumen::Mesh> mesh() { return data<lumen::Mesh>("scan.mesh"); }
  std::shared_ptr<const lumen::Lines> lines() { return data<lumen::Lines>("scan.lines"); }
  std::string messages() { return DataSession::messages("scan"); }
  ScratchFolder folder;
};

#define REQUIRE_DATA() \
  if (!files::exists(LUMEN_TEST_DATA)) GTEST_SKIP() << "no shared data at " << LUMEN_TEST_DATA

TEST(VtkImporter, reads_the_real_meshes_with_the_counts_that_are_known_of_them) {
  REQUIRE_DATA();
  struct Known { const char* file; std::size_t triangles, points; };
  // Quads and polygons count as corners - 2 triangles.
  const Known known[] = {{"abdomen-kidneys-aorta-segmentation.vtp", 169680, 84761}, {"cow.vtp", 5804, 2903},   {"niivue-brain.obj", 9064, 4553},
                         {"suzanne.ply", 968, 1966},                                {"teapot.stl", 894, 480}, {"202-t.vtp", 8114, 4037}};
  Reader bench;
  for (const Known& expected : known) {
    bench.read(files::path(LUMEN_TEST_DATA) / "meshes" / expected.file);
    ASSERT_TRUE(bench.mesh()) << expected.file << bench.messages();
    EXPECT_EQ(bench.mesh()->triangles.size(), expected.triangles) << expected.file;
    EXPECT_EQ(bench.mesh()->positions.size(), expected.points) << expected.file;
    EXPECT_EQ(bench.mesh()->normals.size(), expected.points) << expected.file;
    EXPECT_EQ(bench.mesh()->origin, expected.file);
  }
  ASSERT_TRUE(bench.mesh()->attribute("Face_color"));
  EXPECT_EQ(bench.mesh()->attribute("Face_color")->components, 3);
  EXPECT_NE(bench.messages().find("68 degenerate cells skipped"), std::string::npos);
}

TEST(VtkImporter, reads_polylines_the_same_from_every_encoding) {
  REQUIRE_DATA();
  Reader bench;
  std::vector<glm::vec3> first;
  for (const auto& entry : files::directory_iterator(files::path(LUMEN_TEST_DATA) / "lines" / "encodings")) {
    bench.read(entry.path());
    ASSERT_TRUE(bench.lines()) << bench.messages();
    EXPECT_FALSE(bench.mesh());
    EXPECT_EQ(bench.lines()->count(), 3030u);
    if (first.empty()) first.assign(bench.lines()->positions.begin(), bench.lines()->positions.end());
    EXPECT_TRUE(std::equal(first.begin(), first.end(), bench.lines()->positions.begin(), bench.lines()->positions.end())) << entry.path();
  }
}

TEST(VtkImporter, grids_give_their_boundary_with_their_arrays) {
  REQUIRE_DATA();
  Reader bench;
  for (const char* file : {"fire_ug.vtu", "RectGrid2.vtk", "office.binary.vtk"}) {
    bench.read(files::path(LUMEN_TEST_DATA) / "fields" / file);
    ASSERT_TRUE(bench.mesh()) << file << bench.messages();
    EXPECT_GT(bench.mesh()->triangles.size(), 4000u);
  }
  EXPECT_EQ(bench.mesh()->attribute("vectors")->components, 3);
}

TEST(VtkImporter, reads_subdivision_tags_on_which_vtks_own_reader_crashes) {
  REQUIRE_DATA();
  Reader bench;
  bench.read(files::path(LUMEN_TEST_DATA) / "bad" / "tinyobj" / "catmark_torus_creases0.obj");
  ASSERT_TRUE(bench.mesh()) << bench.messages();
  EXPECT_EQ(bench.mesh()->triangles.size(), 64u);
}

TEST(VtkImporter, says_what_is_wrong_with_a_file_and_where) {
  Reader bench;
  bench.read(bench.folder / "absent.vtp");
  EXPECT_NE(bench.messages().find("absent.vtp: there is no such file"), std::string::npos) << bench.messages();
  bench.read(bench.folder.path());
  EXPECT_NE(bench.messages().find("is no regular file"), std::string::npos) << bench.messages();
  bench.read("/dev/zero");
  EXPECT_NE(bench.messages().find("zero: is no regular file"), std::string::npos) << bench.messages();
  bench.read_text("empty.ply", "");
  EXPECT_NE(bench.messages().find("empty.ply: is empty"), std::string::npos) << bench.messages();
  bench.read_text("cut.vtp", "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\">\n  <PolyData>\n");
  EXPECT_NE(bench.messages().find("cut.vtp:4:"), std::string::npos) << bench.messages();
  bench.read_text("grid.vtp", "<VTKFile type=\"ImageData\" version=\"0.1\"></VTKFile>");
  EXPECT_NE(bench.messages().find("ImageData"), std::string::npos) << bench.messages();
  bench.read_text("short.stl", std::string(80, 'x') + std::string("\xff\xff\xff\x7f", 4) + std::string(50, '\0'));
  EXPECT_NE(bench.messages().find("cut off"), std::string::npos) << bench.messages();
}

TEST(VtkImporter, believes_the_contents_and_not_the_name) {
  Reader bench;
  bench.read_text("triangle.stl", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
                                  "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  ASSERT_TRUE(bench.mesh()) << bench.messages();
  EXPECT_EQ(bench.mesh()->normals[0], glm::vec3(0, 0, 1));
  EXPECT_NE(bench.messages().find("triangle.stl holds PLY"), std::string::npos) << bench.messages();
}

TEST(VtkImporter, cuts_concave_polygons_without_leaving_them) {
  // An arrow head: a fan from its first corner would cover (0.2, 1).
  Reader bench;
  bench.read_text("arrow.obj", "v 0 0 0\nv 2 1 0\nv 0 2 0\nv 1 1 0\nf 1 2 3 4\n");
  ASSERT_TRUE(bench.mesh()) << bench.messages();
  const auto mesh = bench.mesh();
  ASSERT_EQ(mesh->triangles.size(), 2u);
  float area = 0;
  for (const glm::uvec3& t : mesh->triangles) {
    const glm::vec3 doubled = glm::cross(mesh->positions[t.y] - mesh->positions[t.x], mesh->positions[t.z] - mesh->positions[t.x]);
    EXPECT_GT(doubled.z, 0);
    area += doubled.z / 2;
  }
  EXPECT_FLOAT_EQ(area, 1);
}

TEST(VtkImporter, doubles_the_points_of_an_obj_only_where_corners_differ) {
  // Two triangles that share an edge; one of its ends has two texture coordinates.
  Reader bench;
  bench.read_text("seam.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt .5 .5\n"
                              "g first\nf 1/1 2/2 3/3\ng second\nf -4/5 \\\n-2/3 -1/4\nf 1 2 99\n");
  const auto mesh = bench.mesh();
  ASSERT_TRUE(mesh) << bench.messages();
  ASSERT_EQ(mesh->triangles.size(), 2u);
  ASSERT_EQ(mesh->positions.size(), 5u);
  const std::uint32_t doubled = mesh->triangles[1].x;
  EXPECT_EQ(mesh->positions[doubled], glm::vec3(0));
  EXPECT_EQ(mesh->texture_coordinates[doubled], glm::vec2(0.5f));
  EXPECT_EQ(mesh->texture_coordinates[mesh->triangles[0].x], glm::vec2(0));
  EXPECT_EQ(mesh->triangles[0].z, mesh->triangles[1].y);
  EXPECT_EQ(mesh->attribute("GroupIds")->values[1], 1);
  EXPECT_NE(bench.messages().find("1 cells skipped: they name points that are not there"), std::string::npos) << bench.messages();
  bench.read_text("broken.obj", "v 0 0 0\nv 1 0\n");
  EXPECT_NE(bench.messages().find("broken.obj:2: a point needs three numbers"), std::string::npos) << bench.messages();
}

TEST(VtkImporter, cell_arrays_follow_polygons_and_strips_and_unused_points_go) {
  Reader bench;
  bench.read_text("mixed.vtk", "# vtk DataFile Version 3.0\nmixed\nASCII\nDATASET POLYDATA\nPOINTS 8 double\n"
                               "0 0 0 1 0 0 1 1 0 0 1 0 9 9 9 2 0 0 2 1 0 8 8 8\n"
                               "POLYGONS 2 9\n4 0 1 2 3\n3 1 1 2\nTRIANGLE_STRIPS 1 5\n4 1 5 2 6\n"
                               "CELL_DATA 3\nSCALARS kind float 1\nLOOKUP_TABLE default\n10 20 40\n"
                               "POINT_DATA 8\nSCALARS number double 1\nLOOKUP_TABLE default\n0 1 2 3 4 5 6 7\n");
  const auto mesh = bench.mesh();
  ASSERT_TRUE(mesh) << bench.messages();
  ASSERT_EQ(mesh->triangles.size(), 4u);
  ASSERT_EQ(mesh->triangle_cells.size(), 4u);
  const lumen::Attribute* kind = mesh->attribute("kind");
  ASSERT_TRUE(kind);
  const float expected[] = {10, 10, 40, 40};
  for (std::size_t triangle = 0; triangle < 4; ++triangle) EXPECT_EQ(kind->values[mesh->triangle_cells[triangle]], expected[triangle]);
  // Points 4 and 7 are used by nothing.
  EXPECT_EQ(mesh->positions.size(), 6u);
  EXPECT_EQ(mesh->attribute("number")->values[4], 5);
  EXPECT_NE(bench.messages().find("1 degenerate cells skipped"), std::string::npos) << bench.messages();
  for (const glm::vec3& normal : mesh->normals) EXPECT_EQ(normal, glm::vec3(0, 0, 1));
}

TEST(VtkImporter, cells_with_points_that_are_not_finite_are_left_out_and_counted) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float points[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, nan, 0, 0};
  const auto file_of = [&](const std::vector<std::array<std::int32_t, 3>>& triangles) {
    std::string text = "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                       std::to_string(triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
    text.append(reinterpret_cast<const char*>(points), sizeof points);
    for (const auto& triangle : triangles) {
      text += '\3';
      text.append(reinterpret_cast<const char*>(triangle.data()), sizeof triangle);
    }
    return text;
  };
  Reader bench;
  bench.read_text("some.ply", file_of({{0, 1, 2}, {0, 1, 3}}));
  ASSERT_TRUE(bench.mesh()) << bench.messages();
  EXPECT_EQ(bench.mesh()->triangles.size(), 1u);
  EXPECT_EQ(bench.mesh()->positions.size(), 3u);
  EXPECT_NE(bench.messages().find("1 cells skipped: a point of theirs is not finite"), std::string::npos) << bench.messages();
  bench.read_text("none.ply", file_of({{0, 1, 3}}));
  EXPECT_NE(bench.messages().find("none.ply: holds no triangles and no lines"), std::string::npos) << bench.messages();
}

TEST(VtkImporter, an_old_mesh_stays_until_the_new_one_is_there_and_when_it_fails) {
  Reader bench;
  bench.read_text("good.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const auto good = bench.mesh();
  ASSERT_TRUE(good);
  bench.read(bench.folder / "absent.obj");
  EXPECT_EQ(bench.mesh(), good);
  EXPECT_NE(bench.state("scan.mesh"), "ready");
}

std::shared_ptr<lumen::Mesh> tetrahedron() {
  auto mesh = std::make_shared<lumen::Mesh>();
  mesh->origin = "tetrahedron";
  mesh->positions = std::vector<glm::vec3>{{0, 0, 0}, {1.5f, 0, 0}, {0, 2.25f, 0}, {0, 0, 3.125f}};
  mesh->triangles = std::vector<glm::uvec3>{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  mesh->normals = lumen::average_normals(mesh->positions, mesh->triangles);
  mesh->attributes = {{"heat", lumen::Attribute::On::points, 1, std::vector<float>{1, 2, 3, 4}},
                      {"side", lumen::Attribute::On::cells, 2, std::vector<float>{0, 1, 2, 3, 4, 5, 6, 7}}};
  mesh->finish();
  return mesh;
}

class RoundTrip : public testing::TestWithParam<const char*> {};

TEST_P(RoundTrip, a_mesh_comes_back_as_it_was) {
  Reader bench;
  const files::path file = bench.folder / (std::string("out") + GetParam());
  const auto mesh = tetrahedron();
  bench.scheduler.write_file(bench.add("exporter.vtk", "exporter"), mesh, file);
  bench.read(file);
  const auto result = bench.mesh();
  ASSERT_TRUE(result) << bench.messages();
  ASSERT_EQ(result->triangles.size(), 4u);
  EXPECT_EQ(result->positions.size(), 4u);
  for (std::size_t triangle = 0; triangle < 4; ++triangle)
    for (int corner = 0; corner < 3; ++corner)
      EXPECT_EQ(result->positions[result->triangles[triangle][corner]], mesh->positions[mesh->triangles[triangle][corner]]);
  if (std::string(GetParam()).starts_with(".vt")) {
    ASSERT_TRUE(result->attribute("heat") && result->attribute("side"));
    EXPECT_EQ(result->attribute("heat")->values[3], 4);
    EXPECT_EQ(result->attribute("side")->values[5], 5);
    EXPECT_NEAR(glm::distance(result->normals[1], mesh->normals[1]), 0, 1e-6);
  }
  // Nothing but the file itself is left behind.
  EXPECT_EQ(std::distance(files::directory_iterator(bench.folder.path()), files::directory_iterator()), 1);
}
INSTANTIATE_TEST_SUITE_P(Formats, RoundTrip, testing::Values(".vtp", ".vtk", ".stl", ".obj", ".ply"),
                         [](const auto& info) { return std::string(info.param).substr(1); });

TEST(VtkExporter, lines_come_back_with_their_arrays) {
  auto lines = std::make_shared<lumen::Lines>();
  lines->positions = std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {5, 5, 5}, {6, 6, 6}};
  lines->offsets = std::vector<std::uint32_t>{0, 3, 5};
  lines->attributes = {{"speed", lumen::Attribute::On::points, 1, std::vector<float>{1, 2, 3, 4, 5}}, {"bundle", lumen::Attribute::On::cells, 1, std::vector<float>{7, 8}}};
  lines->finish();
  for (const char* extension : {".vtp", ".vtk"}) {
    Reader bench;
    const files::path file = bench.folder / (std::string("lines") + extension);
    bench.scheduler.write_file(bench.add("exporter.vtk", "exporter"), lines, file);
    bench.read(file);
    const auto result = bench.lines();
    ASSERT_TRUE(result) << bench.messages();
    EXPECT_TRUE(std::equal(result->positions.begin(), result->positions.end(), lines->positions.begin(), lines->positions.end()));
    EXPECT_TRUE(std::equal(result->offsets.begin(), result->offsets.end(), lines->offsets.begin(), lines->offsets.end()));
    ASSERT_EQ(result->attributes.size(), 2u);
    EXPECT_EQ(result->attributes[1].values[1], 8);
  }
}

TEST(VtkExporter, refuses_what_it_cannot_write_and_leaves_the_old_file) {
  Reader bench;
  Instance& exporter = bench.add("exporter.vtk", "exporter");
  std::ofstream(bench.folder / "keep.xyz") << "old";
  EXPECT_THROW(bench.scheduler.write_file(exporter, tetrahedron(), bench.folder / "keep.xyz"), lumen::Error);
  std::string kept;
  std::ifstream(bench.folder / "keep.xyz") >> kept;
  EXPECT_EQ(kept, "old");
  EXPECT_THROW(bench.scheduler.write_file(exporter, tetrahedron(), bench.folder / "no-such-folder" / "a.vtp"), lumen::Error);
}

TEST(VtkExporter, writes_what_is_linked_to_it) {
  Reader bench;
  bench.given("source", tetrahedron());
  Instance& exporter = bench.add("exporter.vtk", "exporter");
  bench.session.link("exporter.mesh", "source.mesh");
  bench.session.set("exporter.path", lumen::Value(lumen::Path{(bench.folder / "linked.ply").string()}));
  bench.scheduler.run_export(exporter);
  bench.read(bench.folder / "linked.ply");
  ASSERT_TRUE(bench.mesh());
  EXPECT_EQ(bench.mesh()->triangles.size(), 4u);
}

}  // namespace
}  // namespace lumenshop
