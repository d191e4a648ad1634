/// filter.split: halves that are closed, share the cut, lose nothing, and look as those of splitter.plane.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <map>
#include <set>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <lumen/testing.h>

#include "plugins/closed_mesh.h"
#include "plugins/data_session.h"

namespace lumenshop {
namespace {

namespace files = std::filesystem;
using lumen::Mesh;
using MeshPointer = std::shared_ptr<const Mesh>;

struct Bench : DataSession {
  explicit Bench(lumen::DataPointer input) : Bench() {
    given("source", std::move(input));
    session.link("split.mesh", "source.mesh");
  }
  Bench() { add("filter.split", "split"); }
  template <class T> void set(const std::string& property, T value) { session.set("split." + property, lumen::Value(std::move(value))); }
  void plane(glm::vec3 point, glm::vec3 normal) {
    const glm::vec3 about = glm::cross(glm::vec3(0, 0, 1), normal);
    set("translation", point);
    set("axis", glm::length(about) > 0 ? glm::normalize(about) : glm::vec3(1, 0, 0));
    set("angle", float(glm::degrees(std::atan2(double(glm::length(about)), double(normal.z)))));
  }
  MeshPointer get(const std::string& output) {
    run();
    return data<Mesh>("split." + output);
  }
  std::string messages() { return DataSession::messages("split"); }
};

/// Closed, unlike the meshes of lumen/testing.h, which have seams.
MeshPointer shape(const char* name, int detail) {
  DataSession made;
  made.add("importer.shape", "shape");
  made.session.set("shape.shape", lumen::Value(lumen::Choice{name}));
  made.session.set("shape.detail", lumen::Value(detail));
  made.run();
  return made.data<Mesh>("shape.mesh");
}

glm::dvec3 doubled_area(const Mesh& mesh, const glm::uvec3& t) {
  const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
  return glm::cross(b - a, c - a);
}

/// Triangles with a corner twice, or without any area.
std::size_t degenerate(const Mesh& mesh) {
  std::size_t count = 0;
  for (const glm::uvec3& t : mesh.triangles) count += glm::length(doubled_area(mesh, t)) == 0;
  return count;
}

std::size_t doubled(const Mesh& mesh) {
  std::set<std::array<std::uint32_t, 3>> seen;
  std::size_t count = 0;
  for (const glm::uvec3& t : mesh.triangles) {
    std::array<std::uint32_t, 3> corners{t.x, t.y, t.z};
    std::sort(corners.begin(), corners.end());
    count += !seen.insert(corners).second;
  }
  return count;
}

bool is_cap(const Mesh& mesh, std::size_t triangle) {
  const lumen::Attribute* cap = mesh.attribute("cap");
  return cap != nullptr && cap->values[mesh.triangle_cells[triangle]] == 1;
}

double cap_area(const Mesh& mesh) {
  double area = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    if (is_cap(mesh, i)) area += 0.5 * glm::length(doubled_area(mesh, mesh.triangles[i]));
  return area;
}

std::set<std::array<float, 3>> points_of_caps(const Mesh& mesh) {
  std::set<std::array<float, 3>> points;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    if (is_cap(mesh, i))
      for (int corner = 0; corner < 3; ++corner) {
        const glm::vec3& p = mesh.positions[mesh.triangles[i][corner]];
        points.insert({p.x, p.y, p.z});
      }
  return points;
}

/// All that holds for a closed mesh cut anywhere.
void expect_sound_halves(Bench& bench, const Mesh& source, const std::string& where) {
  const MeshPointer a = bench.get("half_a"), b = bench.get("half_b"), result = bench.get("result");
  ASSERT_TRUE(a && b && result) << where << bench.messages();
  const std::size_t flat_before = degenerate(source);
  for (const MeshPointer& mesh : {a, b, result}) {
    EXPECT_EQ(open_edges(*mesh), 0u) << where << ": " << mesh->origin;
    EXPECT_LE(degenerate(*mesh), flat_before) << where << ": " << mesh->origin;
    EXPECT_EQ(doubled(*mesh), 0u) << where << ": " << mesh->origin;
  }
  const double whole = volume(source);
  EXPECT_NEAR((volume(*a) + volume(*b)) / whole, 1, 1e-5) << where;
  EXPECT_NEAR(volume(*result) / whole, 1, 1e-5) << where;
  EXPECT_EQ(points_of_caps(*a), points_of_caps(*b)) << where;
  EXPECT_EQ(result->triangles.size(), a->triangles.size() + b->triangles.size());
  EXPECT_EQ(bench.messages(), "") << where;
}

const glm::vec3 directions[] = {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}, {1, 1, 0}, {0.3f, -0.5f, 0.8f}};

TEST(SplitFilter, HalvesOfASphereAreClosedAndLoseNothingWhereverItIsCut) {
  const MeshPointer sphere = shape("sphere", 64);
  Bench bench(std::make_shared<Mesh>(*sphere));
  for (const glm::vec3 direction : directions)
    for (const float height : {0.0f, 0.3f, -0.77f}) {
      bench.plane(height * glm::normalize(direction), glm::normalize(direction));
      expect_sound_halves(bench, *sphere, "height " + std::to_string(height));
      const MeshPointer a = bench.get("half_a"), b = bench.get("half_b");
      for (const glm::vec3& p : a->positions) EXPECT_GE(glm::dot(p, glm::normalize(direction)), height - 1e-5f);
      for (const glm::vec3& p : b->positions) EXPECT_LE(glm::dot(p, glm::normalize(direction)), height + 1e-5f);
    }
}

TEST(SplitFilter, UnlessSetThePlaneGoesThroughTheMiddleWhereverTheSurfaceIs) {
  const MeshPointer sphere = shape("sphere", 64);
  Bench bench(lumen::testing::moved(*sphere, {30, -20, 7}));
  EXPECT_NEAR(volume(*bench.get("half_a")) / volume(*sphere), 0.5, 1e-3) << "in the first job that has a surface";
  bench.set("transform", glm::translate(glm::mat4(1), glm::vec3(0, 0, 100)));
  EXPECT_NEAR(volume(*bench.get("half_b")) / volume(*sphere), 0.5, 1e-3);
  EXPECT_NEAR(glm::distance(std::get<glm::vec3>(bench.session.find("split")->read(bench.session.find("split")->slot_of("translation"))), {30, -20, 107}), 0, 1e-4);
  bench.set("translation", glm::vec3(30, -20, 107.5f));
  bench.set("transform", glm::translate(glm::mat4(1), glm::vec3(0, 0, 100.5f)));
  EXPECT_NEAR(volume(*bench.get("half_a")) / volume(*sphere), 0.5, 1e-3);
  bench.set("transform", glm::mat4(1));
  EXPECT_TRUE(bench.get("half_a")->triangles.empty()) << "what was set stays";
}

TEST(SplitFilter, ATorusCutAcrossHasTwoCapsAndCutAlongARing) {
  const MeshPointer torus = shape("torus", 128);
  Bench bench(std::make_shared<Mesh>(*torus));
  for (const glm::vec3 direction : directions) {
    bench.plane(glm::vec3(0), glm::normalize(direction));
    expect_sound_halves(bench, *torus, "torus");
  }
  bench.plane(glm::vec3(0), {1, 0, 0});
  const double disk = std::numbers::pi * 0.3 * 0.3, ring = std::numbers::pi * (1 - 0.4 * 0.4);
  EXPECT_NEAR(cap_area(*bench.get("half_a")) / (2 * disk), 1, 0.01);
  bench.plane(glm::vec3(0), {0, 0, 1});
  EXPECT_NEAR(cap_area(*bench.get("half_a")) / ring, 1, 0.01);
}

TEST(SplitFilter, APhantomWhoseSurfacesLieInOneAnotherHasACapForEach) {
  DataSession made;
  made.add("importer.phantom", "phantom");
  made.session.set("phantom.triangles", lumen::Value(20000));
  made.run();
  for (const char* output : {"phantom.wall", "phantom.lumen", "phantom.mesh"}) {
    const MeshPointer phantom = made.data<Mesh>(output);
    Bench bench(std::make_shared<Mesh>(*phantom));
    for (const glm::vec3 direction : directions) {
      bench.plane(phantom->bounds().center(), glm::normalize(direction));
      if (std::string(output) == "phantom.mesh" || open_edges(*phantom) != 0) {
        ASSERT_TRUE(bench.get("result")) << output;
        EXPECT_EQ(open_edges(*bench.get("result")), open_edges(*phantom)) << output;
        continue;
      }
      expect_sound_halves(bench, *phantom, output);
    }
  }
}

struct Scan : DataSession {
  explicit Scan(const char* file) {
    add("importer.vtk", "scan");
    session.set("scan.path", lumen::Value(lumen::Path{(files::path(LUMEN_TEST_DATA) / "meshes" / file).string()}));
    run();
  }
  std::shared_ptr<Mesh> mesh() { return std::make_shared<Mesh>(*data<Mesh>("scan.mesh")); }
};

TEST(SplitFilter, ARealScanThatIsNoManifoldIsClosedAllTheSame) {
  if (!files::exists(LUMEN_TEST_DATA)) GTEST_SKIP() << "no shared data";
  const auto abdomen = Scan("abdomen-kidneys-aorta-segmentation.vtp").mesh();
  Bench bench(abdomen);
  bench.plane(abdomen->bounds().center() + glm::vec3(0, 0, 10000), {0, 0, 1});
  const double whole = volume(*bench.get("result"));
  bench.plane(abdomen->bounds().center(), {0, 0, 1});
  const MeshPointer a = bench.get("half_a"), b = bench.get("half_b");
  for (const MeshPointer& half : {a, b}) {
    EXPECT_EQ(open_edges(*half), 0u);
    EXPECT_EQ(degenerate(*half), 0u);
    EXPECT_EQ(doubled(*half), 0u);
  }
  EXPECT_NEAR((volume(*a) + volume(*b)) / whole, 1, 1e-5);
  EXPECT_EQ(points_of_caps(*a), points_of_caps(*b));
  EXPECT_GT(cap_area(*a), 1000);
}

TEST(SplitFilter, OpenAndTangledScansAreCutWithOneNote) {
  if (!files::exists(LUMEN_TEST_DATA)) GTEST_SKIP() << "no shared data";
  for (const char* file : {"Torso.vtp", "cow.vtp", "suzanne.ply", "202-t.vtp"}) {
    const auto scan = Scan(file).mesh();
    Bench bench(scan);
    bench.plane(scan->bounds().center(), glm::normalize(glm::vec3(0.1f, 0.2f, 1)));
    const MeshPointer a = bench.get("half_a"), b = bench.get("half_b");
    ASSERT_TRUE(a && b) << bench.messages();
    EXPECT_FALSE(a->triangles.empty());
    EXPECT_FALSE(b->triangles.empty());
    const auto& problems = bench.session.find("split")->problems();
    ASSERT_EQ(problems.size(), 1u) << file;
    EXPECT_EQ(problems.front().severity, lumen::Severity::note);
    EXPECT_EQ(problems.front().message.find("'" + std::string(file) + "' "), 0u) << problems.front().message;
  }
}

std::shared_ptr<Mesh> made_of(std::vector<glm::vec3> positions, std::vector<glm::uvec3> triangles) {
  auto mesh = std::make_shared<Mesh>();
  mesh->origin = "made";
  mesh->positions = std::move(positions);
  mesh->triangles = std::move(triangles);
  return mesh;
}

/// -1..1, its 8 corners shared.
std::shared_ptr<Mesh> cube(glm::vec3 center = glm::vec3(0)) {
  std::vector<glm::vec3> positions;
  for (int corner = 0; corner < 8; ++corner) positions.push_back(center + glm::vec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1));
  std::vector<glm::uvec3> triangles;
  for (const glm::uvec4& quad : {glm::uvec4{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    triangles.emplace_back(quad.x, quad.y, quad.z);
    triangles.emplace_back(quad.x, quad.z, quad.w);
  }
  auto mesh = made_of(std::move(positions), std::move(triangles));
  mesh->finish();
  return mesh;
}

TEST(SplitFilter, APlaneThroughPointsEdgesOrFacesMakesNoSlivers) {
  const auto box = cube();
  Bench bench(box);
  // Through two edges and the diagonals between: no point of the mesh is doubled, half the cube is a prism.
  bench.plane(glm::vec3(0), glm::normalize(glm::vec3(1, 1, 0)));
  expect_sound_halves(bench, *box, "edges");
  EXPECT_EQ(bench.get("half_a")->positions.size() + bench.get("half_b")->positions.size(), 12u + 2 * 2) << "the two diagonals in the way are cut in the middle";
  EXPECT_NEAR(volume(*bench.get("half_a")), 4, 1e-5);
  EXPECT_NEAR(cap_area(*bench.get("half_a")), 2 * 2 * std::numbers::sqrt2, 1e-5);
  // In a face: all is on its other side, and nothing is added.
  for (const float height : {1.0f, -1.0f}) {
    bench.plane({0, 0, height}, {0, 0, 1});
    const MeshPointer full = bench.get(height > 0 ? "half_b" : "half_a"), empty = bench.get(height > 0 ? "half_a" : "half_b");
    EXPECT_EQ(empty->triangles.size(), 0u);
    EXPECT_EQ(full->triangles.size(), 12u);
    EXPECT_EQ(open_edges(*full), 0u);
    EXPECT_EQ(full->attribute("cap"), nullptr);
  }
  // Through one corner alone, from outside.
  bench.plane(glm::vec3(1), glm::normalize(glm::vec3(1)));
  EXPECT_EQ(bench.get("half_a")->triangles.size(), 0u);
}

TEST(SplitFilter, TheCapIsThePolygonOfTheSectionAndCloseToTheDisk) {
  const MeshPointer sphere = shape("sphere", 256);
  Bench bench(std::make_shared<Mesh>(*sphere));
  for (const float height : {0.01f, 0.4f, 0.8f}) {
    const glm::vec3 normal = glm::normalize(glm::vec3(0.2f, 0.9f, -0.3f));
    bench.plane(height * normal, normal);
    const MeshPointer half = bench.get("half_a");
    // The polygon's area by its border: the cap's edges that the rest of the half shares.
    glm::dvec3 doubled_polygon(0);
    std::map<std::pair<std::uint32_t, std::uint32_t>, bool> of_cap;
    for (std::size_t i = 0; i < half->triangles.size(); ++i)
      for (int corner = 0; corner < 3; ++corner) of_cap[{half->triangles[i][corner], half->triangles[i][(corner + 1) % 3]}] = is_cap(*half, i);
    for (const auto& [edge, cap] : of_cap)
      if (cap && !of_cap.at({edge.second, edge.first})) doubled_polygon += glm::cross(glm::dvec3(half->positions[edge.first]), glm::dvec3(half->positions[edge.second]));
    const double exact = 0.5 * std::abs(glm::dot(doubled_polygon, glm::dvec3(normal)));
    EXPECT_NEAR(cap_area(*half) / exact, 1, 1e-5);
    EXPECT_NEAR(cap_area(*half) / (std::numbers::pi * (1 - double(height) * height)), 1, 0.01);
  }
}

TEST(SplitFilter, TheTransformMovesThePlaneIntoTheMeshesOwnSpace) {
  const MeshPointer sphere = shape("sphere", 128);
  Bench bench(std::make_shared<Mesh>(*sphere));
  glm::mat4 transform = glm::scale(glm::translate(glm::mat4(1), glm::vec3(5, 0, 0)), glm::vec3(3, 1, 0.5f));
  bench.set("transform", transform);
  const glm::vec3 normal = glm::normalize(glm::vec3(1, 1, 0));
  bench.plane({5.6f, 0, 0}, normal);
  bench.set("offset", 0.25f);
  const MeshPointer a = bench.get("half_a"), b = bench.get("half_b");
  ASSERT_TRUE(a && b) << bench.messages();
  EXPECT_EQ(open_edges(*a) + open_edges(*b), 0u);
  const auto world = [&](const glm::vec3& p) { return glm::vec3(transform * glm::vec4(p, 1)); };
  float lowest = 10, highest = -10, drift = 0;
  for (const glm::vec3& p : a->positions) lowest = std::min(lowest, glm::dot(world(p) - glm::vec3(5.6f, 0, 0), normal));
  for (const glm::vec3& p : b->positions) highest = std::max(highest, glm::dot(world(p) - glm::vec3(5.6f, 0, 0), normal));
  EXPECT_NEAR(lowest, 0.25f, 1e-5f);
  EXPECT_NEAR(highest, -0.25f, 1e-5f);
  // Moved along the world's normal alone: back by it, each point is on the ellipsoid or in the plane.
  for (std::size_t i = 0; i < a->positions.size(); ++i)
    drift = std::max(drift, glm::length(glm::vec3(glm::inverse(transform) * glm::vec4(world(a->positions[i]) - 0.25f * normal, 1))) - 1);
  EXPECT_LT(drift, 1e-5f);
}

TEST(SplitFilter, ArraysFollowTheCutAndCapsHaveTheCellsOfTheirPart) {
  auto mesh = cube();
  std::vector<float> heights, parts, cells;
  for (const glm::vec3& p : mesh->positions) heights.insert(heights.end(), {p.z, 2 * p.x});
  std::vector<std::uint32_t> cell_numbers;
  for (std::uint32_t i = 0; i < 12; ++i) cell_numbers.push_back(i / 2);
  for (int i = 0; i < 6; ++i) parts.push_back(7);
  mesh->triangle_cells = cell_numbers;
  mesh->attributes = {{"place", lumen::Attribute::On::points, 2, std::move(heights)}, {"label", lumen::Attribute::On::cells, 1, std::move(parts)}};
  mesh->finish();
  Bench bench(mesh);
  bench.plane({0, 0, 0.5f}, {0, 0, 1});
  const MeshPointer result = bench.get("result");
  ASSERT_TRUE(result) << bench.messages();
  const lumen::Attribute *place = result->attribute("place"), *label = result->attribute("label"), *cap = result->attribute("cap");
  ASSERT_TRUE(place && label && cap);
  for (std::size_t i = 0; i < result->positions.size(); ++i) {
    EXPECT_NEAR(place->values[2 * i], result->positions[i].z, 1e-6f);
    EXPECT_NEAR(place->values[2 * i + 1], 2 * result->positions[i].x, 1e-6f);
  }
  std::size_t caps = 0;
  for (std::size_t i = 0; i < result->triangles.size(); ++i) {
    const std::uint32_t cell = result->triangle_cells[i];
    const glm::uvec3& t = result->triangles[i];
    const bool flat = std::abs(result->positions[t.x].z - 0.5f) + std::abs(result->positions[t.y].z - 0.5f) + std::abs(result->positions[t.z].z - 0.5f) < 1e-6f;
    EXPECT_EQ(cap->values[cell] == 1, flat);
    EXPECT_EQ(cell >= 6, flat) << "the mesh has the cells 0 to 5";
    EXPECT_EQ(label->values[cell], 7);
    caps += flat;
  }
  EXPECT_EQ(caps, 2 * 6u) << "of eight points in a row around a square";
}

TEST(SplitFilter, WhatIsCutTwiceIsClosedAndItsCapsStayMarked) {
  const MeshPointer sphere = shape("sphere", 64);
  DataSession bench;
  bench.given("source", std::make_shared<Mesh>(*sphere));
  bench.add("filter.split", "first");
  bench.add("filter.split", "second");
  bench.session.link("first.mesh", "source.mesh");
  bench.session.link("second.mesh", "first.half_a");
  bench.session.set("second.axis", lumen::Value(glm::vec3(0, 1, 0)));
  bench.session.set("second.angle", lumen::Value(90.0f));
  bench.run();
  const MeshPointer quarter = bench.data<Mesh>("second.half_a");
  ASSERT_TRUE(quarter) << bench.messages("second");
  EXPECT_EQ(open_edges(*quarter), 0u);
  EXPECT_NEAR(volume(*quarter) / (std::numbers::pi / 3), 1, 0.01);
  EXPECT_NEAR(cap_area(*quarter) / std::numbers::pi, 1, 0.01) << "two half disks";
}

TEST(SplitFilter, PartsThatStayWholeStayInPlaceAndBelongToNoHalf) {
  const auto both = lumen::testing::joined({cube({-2, 0, 0}), cube({2, 0, 0})});
  Bench bench(both);
  bench.set("whole", std::vector<int>{1});
  bench.set("offset", 0.5f);
  const MeshPointer a = bench.get("half_a"), result = bench.get("result");
  ASSERT_TRUE(a && result) << bench.messages();
  EXPECT_LT(a->bounds().max.x, 0);
  EXPECT_EQ(open_edges(*result), 0u);
  std::size_t in_place = 0;
  for (const glm::vec3& p : result->positions) in_place += p.x > 0 && std::abs(p.z) == 1;
  EXPECT_EQ(in_place, 8u);
}

TEST(SplitFilter, TouchingCubesAreTakenApartAndTurnedCubesTurnedBack) {
  // Two cubes that share an edge, four triangles at it; one triangle of the first is turned around.
  const auto first = cube({-1, -1, 0}), second = cube({1, 1, 0});
  std::vector<glm::vec3> positions(first->positions.begin(), first->positions.end());
  std::vector<glm::uvec3> triangles(first->triangles.begin(), first->triangles.end());
  std::vector<std::uint32_t> number;
  for (const glm::vec3& p : second->positions) {
    const auto same = std::find(positions.begin(), positions.begin() + 8, p);
    number.push_back(std::uint32_t(same - positions.begin()));
    if (same == positions.begin() + 8) number.back() = std::uint32_t(positions.size()), positions.push_back(p);
  }
  ASSERT_EQ(positions.size(), 14u);
  for (const glm::uvec3& t : second->triangles) triangles.emplace_back(number[t.x], number[t.y], number[t.z]);
  std::swap(triangles[0].x, triangles[0].y);
  auto mesh = made_of(std::move(positions), std::move(triangles));
  mesh->finish();
  Bench bench(mesh);
  bench.plane({0, 0, 0.25f}, {0, 0, 1});
  const MeshPointer a = bench.get("half_a");
  ASSERT_TRUE(a);
  EXPECT_EQ(bench.messages(), "'made' is no manifold (2 points doubled, 1 triangle turned)\n");
  EXPECT_EQ(open_edges(*a), 0u);
  EXPECT_NEAR(volume(*a), 2 * 4 * 0.75, 1e-5);
}

TEST(SplitFilter, WithoutCapsNothingIsSaidAndTheHalvesStayOpen) {
  Bench bench(cube());
  bench.set("capped", false);
  const MeshPointer a = bench.get("half_a");
  ASSERT_TRUE(a);
  EXPECT_EQ(open_edges(*a), 8u);
  EXPECT_EQ(bench.messages(), "");
}

TEST(SplitFilter, WrittenFilesAreClosed) {
  const MeshPointer sphere = shape("sphere", 48);
  Bench bench(std::make_shared<Mesh>(*sphere));
  bench.set("offset", 0.2f);
  ASSERT_TRUE(bench.get("result"));
  bench.add("exporter.vtk", "writer");
  const ScratchFolder folder;
  for (const char* name : {"split.stl", "split.ply", "split.vtp"}) {
    bench.scheduler.write_file(*bench.session.find("writer"), bench.data<Mesh>("split.result"), folder / name);
    DataSession reader;
    reader.add("importer.vtk", "scan");
    reader.session.set("scan.path", lumen::Value(lumen::Path{(folder / name).string()}));
    reader.run();
    const MeshPointer back = reader.data<Mesh>("scan.mesh");
    ASSERT_TRUE(back) << name << reader.messages("scan");
    EXPECT_EQ(open_edges(*back), 0u) << name;
    EXPECT_EQ(back->triangles.size(), bench.data<Mesh>("split.result")->triangles.size()) << name;
    EXPECT_NEAR(volume(*back) / volume(*sphere), 1, 1e-4) << name;
  }
}

/// A scene in which a sphere is cut by the splitter, and one in which the filter has cut it.
struct Pair {
  lumen::testing::Scene image{{160, 160}}, object{{160, 160}};

  Pair(const std::shared_ptr<Mesh>& mesh, const char* camera, const char* plane, bool capped, const char* interior) {
    for (lumen::testing::Scene* scene : {&image, &object}) {
      scene->add("ambient.constant", "ambient");
      scene->add("diffuse.lambert", "diffuse");
      scene->add("interactor.orbit", "eye", camera);
      scene->set("main.camera", "eye");
      scene->surface("ball", mesh, R"({"ambient": "ambient", "diffuse": "diffuse", "transform": [1,0,0,0, 0,0.8,0,0, 0,0,1.2,0, 0,0,0,1]})");
    }
    image.add("splitter.plane", "cut", plane);
    image.set("cut.interior", interior);
    image.set("ball.splitter", "cut");
    object.add("filter.split", "cut", plane);
    object.set("cut.mesh", R"({"link": "ball_data.mesh"})");
    object.set("cut.transform", R"({"link": "ball.transform"})");
    object.set("cut.capped", capped ? "true" : "false");
    object.set("cut.doubled", capped ? "true" : "false");
    object.set("ball.mesh", R"({"link": "cut.result"})");
  }
  /// Pixels where a layer of the two differs by more than `tolerance`.
  int different(const std::string& layer, float tolerance) {
    const lumen::testing::Pixels a = image.layer(layer), b = object.layer(layer);
    int count = 0;
    for (int y = 0; y < 160; ++y)
      for (int x = 0; x < 160; ++x)
        for (int c = 0; c < a.channels(); ++c)
          if (!(std::abs(a.at(x, y, c) - b.at(x, y, c)) <= tolerance) && a.at(x, y, c) != b.at(x, y, c)) {
            ++count;
            break;
          }
    return count;
  }
};

constexpr const char* seen_from_aside = R"({"rotation": [0.9, 0.2, 0.35, 0.1], "projection": "orthographic", "height": 3.2, "pivot": [0, 0, 0], "distance": 10})";
constexpr const char* oblique = R"({"axis": [0.6, 0.8, 0], "angle": 62, "translation": [0.1, 0, 0.05], "offset": 0.2})";

TEST(SplitFilter, ItsPictureIsTheImageSpaceOneWithAndWithoutCaps) {
  const MeshPointer sphere = shape("sphere", 96);
  for (const bool capped : {false, true}) {
    Pair pair(std::make_shared<Mesh>(*sphere), seen_from_aside, oblique, capped, capped ? "cap" : "none");
    EXPECT_TRUE(pair.object.problems().empty());
    // Triangles that were cut are rasterized anew: at a silhouette or the rim, a sample may fall to the other side of an edge.
    EXPECT_LE(pair.different("depth", 1e-4f), 20) << capped;
    EXPECT_LE(pair.different("normal", 2e-3f), 20) << capped;
    const auto depth = pair.object.layer("depth");
    int covered = 0;
    for (int y = 0; y < 160; ++y)
      for (int x = 0; x < 160; ++x) covered += std::isfinite(depth.at(x, y));
    EXPECT_GT(covered, 5000);
  }
}

TEST(SplitFilter, ItsPictureOfAPhantomIsTheImageSpaceOne) {
  DataSession made;
  made.add("importer.phantom", "phantom");
  made.session.set("phantom.triangles", lumen::Value(20000));
  made.run();
  const auto wall = std::make_shared<Mesh>(*made.data<Mesh>("phantom.wall"));
  const std::string camera = R"({"rotation": [-0.637, -0.0708, -0.2973, 0.7077], "pivot": [2, 0, 78], "distance": 470})";
  Pair pair(wall, camera.c_str(), R"({"axis": [0, 1, 0], "angle": 90, "translation": [5, 0, 60], "offset": 12})", false, "none");
  EXPECT_LE(pair.different("depth", 1e-4f * 470), 20);
  // Normals are mixed in another rhythm between points of the cut, where they are unit again: by a degree in triangles as coarse as these.
  EXPECT_LE(pair.different("normal", 0.02f), 20);
}

TEST(SplitFilter, IsProposedOnceTheCutOfALargeMeshRests) {
  lumen::testing::Scene scene({32, 32});
  scene.add("ambient.constant", "ambient");
  scene.add("splitter.plane", "cut", R"({"many_triangles": 3000, "interior": "none"})");
  scene.surface("ball", lumen::testing::sphere(64), R"({"ambient": "ambient", "splitter": "cut"})");
  const auto draw = [&](int frames) {
    for (int frame = 0; frame < frames; ++frame) {
      scene.set("camera.height", std::to_string(2 + 0.01 * frame));
      scene.layer("depth");
    }
    return scene.problems();
  };
  EXPECT_TRUE(draw(20).empty()) << "the plane may still be looked for";
  const auto said = draw(20);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(said.front().instance, "cut");
  EXPECT_EQ(said.front().severity, lumen::Severity::note);
  EXPECT_NE(said.front().message.find("3,968 triangles"), std::string::npos) << said.front().message;
  EXPECT_EQ(draw(5).size(), 1u) << "one line, as long as it holds";
  scene.set("cut.offset", "0.1");
  EXPECT_EQ(draw(2).size(), 1u) << "the offset costs nothing";
  scene.set("cut.angle", "3");
  EXPECT_TRUE(draw(2).empty()) << "it does not rest";
  scene.set("cut.many_triangles", "5000");
  EXPECT_TRUE(draw(40).empty()) << "not so large";
}

}  // namespace
}  // namespace lumenshop
