/// filter.curvature against closed forms, on clean and on bad meshes.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <lumen/mesh.h>
#include <lumen/testing.h>

#include "plugins/data_session.h"

namespace lumenshop {
namespace {

struct Curvature {
  glm::mat3 tensor{0};
  float mean = 0, gaussian = 0;
};

struct Filtered : DataSession {
  explicit Filtered(std::shared_ptr<const lumen::Mesh> input) : source(std::move(input)) {
    given("source", source);
    add("filter.curvature", "bent");
    session.link("bent.mesh", "source.mesh");
  }
  std::vector<Curvature> points() {
    run();
    result = data<lumen::Mesh>("bent.result");
    if (result == nullptr) throw std::runtime_error(messages("bent"));
    const auto &tensors = result->attribute("curvature")->values, &mean = result->attribute("mean_curvature")->values, &gaussian = result->attribute("gaussian_curvature")->values;
    std::vector<Curvature> found;
    for (std::size_t i = 0; i < mean.size(); ++i) {
      const float* c = tensors.data() + 6 * i;
      found.push_back({glm::mat3(c[0], c[3], c[5], c[3], c[1], c[4], c[5], c[4], c[2]), mean[i], gaussian[i]});
    }
    return found;
  }
  std::shared_ptr<const lumen::Mesh> source, result;
};

/// 2 pi times the part of a round; the end is exactly where the beginning is.
double angle_of(double part) { return part < 1 ? 2 * std::numbers::pi * part : 0; }

/// A grid over (u, v) in 0..1 squared, both ends included, whose points `place` gives with normals.
std::shared_ptr<lumen::Mesh> sheet(int columns, int rows, const std::function<std::pair<glm::vec3, glm::vec3>(double, double)>& place) {
  auto mesh = std::make_shared<lumen::Mesh>();
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::uvec3> triangles;
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column <= columns; ++column) {
      const auto [position, normal] = place(double(column) / columns, double(row) / rows);
      positions.push_back(position);
      normals.push_back(normal);
      if (row == rows || column == columns) continue;
      const auto a = std::uint32_t(row * (columns + 1) + column), b = a + std::uint32_t(columns) + 1;
      triangles.emplace_back(a, a + 1, b + 1);
      triangles.emplace_back(a, b + 1, b);
    }
  mesh->origin = "sheet";
  mesh->positions = std::move(positions);
  mesh->normals = std::move(normals);
  mesh->triangles = std::move(triangles);
  mesh->finish();
  return mesh;
}

std::shared_ptr<lumen::Mesh> changed(const lumen::Mesh& mesh, const std::function<void(lumen::Mesh&)>& change) {
  auto copy = std::make_shared<lumen::Mesh>(mesh);
  change(*copy);
  copy->finish();
  return copy;
}

std::shared_ptr<lumen::Mesh> without_normals(const lumen::Mesh& mesh) {
  return changed(mesh, [](lumen::Mesh& copy) { copy.normals = {}; });
}

/// Every triangle with points of its own, and its own normal at them if so wished.
std::shared_ptr<lumen::Mesh> torn(const lumen::Mesh& mesh, bool flat_normals) {
  return changed(mesh, [&](lumen::Mesh& copy) {
    std::vector<glm::vec3> positions, normals;
    std::vector<glm::uvec3> triangles;
    for (const glm::uvec3& t : mesh.triangles) {
      const glm::vec3 normal = glm::cross(mesh.positions[t.y] - mesh.positions[t.x], mesh.positions[t.z] - mesh.positions[t.x]);
      triangles.push_back(glm::uvec3(std::uint32_t(positions.size())) + glm::uvec3(0, 1, 2));
      for (int corner = 0; corner < 3; ++corner) {
        positions.push_back(mesh.positions[t[corner]]);
        normals.push_back(glm::length(normal) > 0 ? glm::normalize(normal) : glm::vec3(0));
      }
    }
    copy.positions = std::move(positions);
    copy.normals = flat_normals ? lumen::Array<glm::vec3>(std::move(normals)) : lumen::Array<glm::vec3>();
    copy.triangles = std::move(triangles);
  });
}

void expect_tensor_near(const glm::mat3& found, const glm::mat3& wanted, float tolerance) {
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) ASSERT_NEAR(found[c][r], wanted[c][r], tolerance) << c << ", " << r;
}

TEST(CurvatureFilter, OfASphereIsOneOverItsRadiusInEveryDirection) {
  for (const float radius : {1e-3f, 1.0f, 250.0f}) {
    Filtered bench(lumen::testing::sphere(48, radius));
    const auto points = bench.points();
    ASSERT_EQ(points.size(), bench.source->positions.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const glm::vec3 n = glm::normalize(bench.source->positions[i]);
      expect_tensor_near(radius * points[i].tensor, glm::mat3(1) - glm::outerProduct(n, n), 2e-3f);
      ASSERT_NEAR(radius * points[i].mean, 1, 2e-3f);
      ASSERT_NEAR(radius * radius * points[i].gaussian, 1, 4e-3f);
    }
    EXPECT_EQ(bench.messages("bent"), "");
  }
}

TEST(CurvatureFilter, OfASphereWithoutNormalsIsTheSameAndItGetsNormals) {
  Filtered bench(without_normals(*lumen::testing::sphere(96)));
  const auto points = bench.points();
  ASSERT_EQ(bench.result->normals.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_NEAR(points[i].mean, 1, 0.02f) << i;
    ASSERT_GT(glm::dot(bench.result->normals[i], bench.source->positions[i]), 0.999f);
  }
}

TEST(CurvatureFilter, SeamsAreClosed) {
  const auto whole = lumen::testing::sphere(96);
  for (const bool flat_normals : {false, true}) {
    Filtered bench(torn(*whole, flat_normals));
    const auto points = bench.points();
    double worst = 0, sum = 0;
    for (const Curvature& point : points) {
      worst = std::max(worst, std::abs(point.mean - 1.0));
      sum += point.mean;
    }
    EXPECT_NEAR(sum / double(points.size()), 1, 0.01);
    EXPECT_LT(worst, flat_normals ? 0.15 : 0.02);
  }
}

TEST(CurvatureFilter, CreasesStayFlatOnBothSides) {
  Filtered bench(lumen::testing::box());
  for (const Curvature& point : bench.points()) EXPECT_EQ(point.tensor, glm::mat3(0));
}

TEST(CurvatureFilter, OfACylinderRunsAroundIt) {
  constexpr float radius = 0.7f;
  const auto mesh = sheet(64, 20, [](double u, double v) {
    const double angle = angle_of(u);
    const glm::vec3 out(std::cos(angle), std::sin(angle), 0);
    return std::pair(radius * out + glm::vec3(0, 0, v), out);
  });
  Filtered bench(mesh);
  const auto points = bench.points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::vec3 around(-mesh->normals[i].y, mesh->normals[i].x, 0);
    expect_tensor_near(radius * points[i].tensor, glm::outerProduct(around, around), 0.01f);
    ASSERT_NEAR(radius * points[i].mean, 0.5f, 0.005f);
    ASSERT_NEAR(radius * radius * points[i].gaussian, 0, 0.005f);
  }
}

TEST(CurvatureFilter, OfATorusHasBothSigns) {
  constexpr double ring = 1.0, tube = 0.4;
  const auto mesh = sheet(160, 64, [](double u, double v) {
    const double a = angle_of(u), b = angle_of(v);
    const glm::dvec3 out(std::cos(a), std::sin(a), 0), normal = std::cos(b) * out + std::sin(b) * glm::dvec3(0, 0, 1);
    return std::pair(glm::vec3(ring * out + tube * normal), glm::vec3(normal));
  });
  for (const bool exact_normals : {true, false}) {
    Filtered bench(exact_normals ? mesh : without_normals(*mesh));
    const auto points = bench.points();
    const float tolerance = exact_normals ? 0.015f : 0.03f;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const glm::vec3& at = mesh->positions[i];
      const double from_axis = std::hypot(at.x, at.y), across = 1 / tube, along = (from_axis - ring) / tube / from_axis;
      ASSERT_NEAR(points[i].mean, (across + along) / 2, tolerance * across);
      ASSERT_NEAR(points[i].gaussian, across * along, tolerance * across * across);
      const glm::vec3 tangent(-at.y / from_axis, at.x / from_axis, 0);
      ASSERT_NEAR(glm::dot(tangent, points[i].tensor * tangent), along, tolerance * across);
    }
  }
}

TEST(CurvatureFilter, OfASaddleIsThatOfItsHeightsAlsoAtItsBorder) {
  constexpr double a = 0.8, b = -0.5, c = 0.6;  // z = a x^2 + b y^2 + c x y
  const auto mesh = sheet(60, 60, [](double u, double v) {
    const double x = 2 * u - 1, y = 2 * v - 1;
    return std::pair(glm::vec3(x, y, a * x * x + b * y * y + c * x * y), glm::vec3(glm::normalize(glm::dvec3(-2 * a * x - c * y, -2 * b * y - c * x, 1))));
  });
  Filtered bench(mesh);
  const auto points = bench.points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::dvec3 at(mesh->positions[i]);
    const double fx = 2 * a * at.x + c * at.y, fy = 2 * b * at.y + c * at.x, square = 1 + fx * fx + fy * fy;
    ASSERT_NEAR(points[i].mean, -((1 + fy * fy) * 2 * a - 2 * fx * fy * c + (1 + fx * fx) * 2 * b) / (2 * std::pow(square, 1.5)), 0.03);
    ASSERT_NEAR(points[i].gaussian, (4 * a * b - c * c) / (square * square), 0.05);
  }
}

TEST(CurvatureFilter, SignsFollowTheNormals) {
  const auto ball = lumen::testing::sphere(48);
  const auto inward = changed(*ball, [&](lumen::Mesh& copy) {
    std::vector<glm::vec3> normals;
    for (const glm::vec3& normal : ball->normals) normals.push_back(-normal);
    copy.normals = std::move(normals);
  });
  Filtered bench(inward);
  for (const Curvature& point : bench.points()) {
    ASSERT_NEAR(point.mean, -1, 2e-3f);
    ASSERT_NEAR(point.gaussian, 1, 4e-3f);
  }
}

std::shared_ptr<lumen::Mesh> inside_out(const lumen::Mesh& mesh) {
  return changed(mesh, [&](lumen::Mesh& copy) {
    std::vector<glm::vec3> normals;
    for (const glm::vec3& normal : mesh.normals) normals.push_back(-normal);
    std::vector<glm::uvec3> triangles;
    for (const glm::uvec3& t : mesh.triangles) triangles.emplace_back(t.x, t.z, t.y);
    copy.normals = std::move(normals);
    copy.triangles = std::move(triangles);
  });
}

TEST(CurvatureFilter, ClosedPartsAreTurnedOutwardUnlessTheyAreCavities) {
  // A ball that is inside out, beside a shell whose cavity faces inward as it shall.
  const auto beside = lumen::testing::moved(*inside_out(*lumen::testing::sphere(32)), {3, 0, 0});
  const auto mesh = lumen::testing::joined({beside, lumen::testing::sphere(32), inside_out(*lumen::testing::sphere(32, 0.5f))});
  Filtered bench(mesh);
  const auto points = bench.points();
  std::vector<bool> used(points.size(), false);
  for (const glm::uvec3& t : mesh->triangles) used[t.x] = used[t.y] = used[t.z] = true;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!used[i]) continue;
    const glm::vec3& at = mesh->positions[i];
    const bool is_beside = at.x > 1.5f, is_cavity = glm::length(at) < 0.7f;
    ASSERT_NEAR(points[i].mean, is_cavity ? -2 : 1, 5e-3f) << i;
    ASSERT_EQ(bench.result->normals[i], is_beside ? -mesh->normals[i] : mesh->normals[i]);
  }
  const glm::uvec3 first = bench.result->triangles[0];
  EXPECT_EQ(first, glm::uvec3(mesh->triangles[0].x, mesh->triangles[0].z, mesh->triangles[0].y));
  EXPECT_EQ(bench.result->triangles[mesh->triangles.size() - 1], mesh->triangles[mesh->triangles.size() - 1]);
}

TEST(CurvatureFilter, SmoothingTakesNoiseAwayAndKeepsTheMean) {
  const auto ball = without_normals(*lumen::testing::sphere(96));
  std::mt19937 random(7);
  std::uniform_real_distribution<float> noise(-2e-4f, 2e-4f);
  const auto rough = changed(*ball, [&](lumen::Mesh& copy) {
    std::vector<glm::vec3> positions;
    for (const glm::vec3& p : ball->positions) positions.push_back(p * (1 + noise(random)));
    copy.positions = std::move(positions);
  });
  Filtered bench(rough);
  const auto spread = [&](int passes) {
    bench.session.set("bent.smoothing", lumen::Value(passes));
    const auto points = bench.points();
    double sum = 0, squares = 0, count = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (std::abs(ball->positions[i].z) > 0.9f) continue;  // points crowd at the poles
      sum += points[i].mean;
      squares += (points[i].mean - 1.0) * (points[i].mean - 1.0);
      ++count;
    }
    EXPECT_NEAR(sum / count, 1, 0.03) << passes;
    return std::sqrt(squares / count);
  };
  EXPECT_LT(spread(6), spread(0) / 3);
}

TEST(CurvatureFilter, BadTrianglesLeaveFiniteNumbersAndANote) {
  auto mesh = std::make_shared<lumen::Mesh>();
  mesh->origin = "odds";
  // Three leaves on one edge, a triangle without area, one that uses a point twice, a point that nobody uses.
  mesh->positions = std::vector<glm::vec3>{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 0, 1}, {5, 0, 0}, {6, 0, 0}, {7, 0, 0}, {9, 9, 9}};
  mesh->triangles = std::vector<glm::uvec3>{{0, 2, 1}, {0, 1, 3}, {0, 1, 4}, {5, 6, 7}, {5, 5, 6}};
  mesh->finish();
  Filtered bench(mesh);
  for (const Curvature& point : bench.points())
    for (int c = 0; c < 3; ++c)
      for (int r = 0; r < 3; ++r) EXPECT_TRUE(std::isfinite(point.tensor[c][r]));
  EXPECT_NE(bench.messages("bent").find("points of odds have no curvature"), std::string::npos) << bench.messages("bent");
}

TEST(CurvatureFilter, ReplacesItsArraysAndKeepsTheOthers) {
  const auto ball = changed(*lumen::testing::sphere(16), [](lumen::Mesh& copy) {
    copy.attributes = {{"mean_curvature", lumen::Attribute::On::points, 1, std::vector<float>(copy.positions.size(), 99.0f)},
                       {"part", lumen::Attribute::On::cells, 1, std::vector<float>(copy.triangles.size(), 3.0f)}};
  });
  Filtered bench(ball);
  EXPECT_NEAR(bench.points().front().mean, 1, 0.01f);
  EXPECT_EQ(bench.result->attributes.size(), 4u);
  EXPECT_EQ(bench.result->attribute("part")->values[0], 3);
}

TEST(CurvatureFilter, WithoutAMeshSaysWhatIsMissing) {
  DataSession bench;
  bench.add("filter.curvature", "bent");
  bench.run();
  EXPECT_NE(bench.state("bent.result").find("link a mesh"), std::string::npos) << bench.state("bent.result");
}

TEST(CurvatureFilter, OfScannedSurfacesIsFinite) {
  const std::filesystem::path folder = std::filesystem::path(LUMEN_TEST_DATA) / "meshes";
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "no data in " << folder;
  for (const char* file : {"abdomen-kidneys-aorta-segmentation.vtp", "cow.vtp", "202-t.vtp", "Torso.vtp", "suzanne.ply", "teapot.stl"}) {
    if (!std::filesystem::exists(folder / file)) continue;
    DataSession bench;
    bench.add("importer.vtk", "scan");
    bench.session.set("scan.path", lumen::Value(lumen::Path{(folder / file).string()}));
    bench.add("filter.curvature", "bent");
    bench.session.link("bent.mesh", "scan.mesh");
    bench.run();
    const auto result = bench.data<lumen::Mesh>("bent.result");
    ASSERT_TRUE(result) << file << ": " << bench.messages("bent") << bench.messages("scan");
    const auto& tensors = result->attribute("curvature")->values;
    ASSERT_EQ(tensors.size(), 6 * result->positions.size());
    EXPECT_TRUE(std::all_of(tensors.begin(), tensors.end(), [](float value) { return std::isfinite(value); })) << file;
    EXPECT_TRUE(std::any_of(tensors.begin(), tensors.end(), [](float value) { return value != 0; })) << file;
  }
}

}  // namespace
}  // namespace lumenshop
