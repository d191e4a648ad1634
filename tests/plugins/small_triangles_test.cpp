/// Triangles smaller than a pixel: what covers no center may be left out, what covers one may not.
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <lumen/mesh.h>
#include <lumen/testing.h>

namespace {

using lumen::testing::Pixels;
using lumen::testing::Scene;

constexpr int size = 64;
constexpr float units_per_pixel = 2.2f / size;  // of the scene's camera

/// Twice the area of (a, b, p), positive where p is to the left.
double side(glm::dvec2 a, glm::dvec2 b, glm::dvec2 p) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); }

/// How far inside of the triangle the point is, pixels; negative outside.
double inside(const std::array<glm::dvec2, 3>& t, glm::dvec2 p) {
  const double turn = side(t[0], t[1], t[2]) < 0 ? -1 : 1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) least = std::min(least, turn * side(t[i], t[(i + 1) % 3], p) / glm::length(t[(i + 1) % 3] - t[i]));
  return least;
}

/// A triangle in pixels, from the upper left.
struct Drawn {
  std::array<glm::dvec2, 3> corners;
  double depth;
};

std::vector<Drawn> drawn_of(const lumen::Mesh& mesh) {
  std::vector<Drawn> drawn;
  for (const glm::uvec3& triangle : mesh.triangles) {
    Drawn& each = drawn.emplace_back();
    for (int i = 0; i < 3; ++i) {
      const glm::dvec3 position(mesh.positions[triangle[i]]);
      each.corners[std::size_t(i)] = glm::dvec2(position.x, -position.y) / double(units_per_pixel) + 0.5 * size;
      each.depth = 10 - position.z;
    }
  }
  return drawn;
}

/// Triangles anywhere in the picture and around it, of either orientation, from a tenth of a pixel to three pixels across.
std::shared_ptr<lumen::Mesh> soup(int count) {
  std::vector<glm::vec3> positions;
  std::vector<glm::uvec3> triangles;
  std::mt19937 random(7);
  std::uniform_real_distribution<float> unit(0, 1);
  for (int i = 0; i < count; ++i) {
    const glm::vec3 center(2.4f * unit(random) - 1.2f, 2.4f * unit(random) - 1.2f, 2 * unit(random) - 1);
    const float reach = units_per_pixel * 1.5f * std::pow(0.03f, unit(random));
    for (int corner = 0; corner < 3; ++corner) positions.push_back(center + reach * glm::vec3(2 * unit(random) - 1, 2 * unit(random) - 1, 0));
    triangles.push_back(glm::uvec3(3 * i) + glm::uvec3(0, 1, 2));
  }
  auto mesh = std::make_shared<lumen::Mesh>();
  mesh->positions = std::move(positions);
  mesh->triangles = std::move(triangles);
  mesh->finish();
  return mesh;
}

TEST(SmallTriangles, CoverWhatTheirAreaCovers) {
  const auto mesh = soup(9000);
  Scene scene({size, size});
  scene.surface("soup", mesh);
  const Pixels depth = scene.layer("depth");
  const std::vector<Drawn> drawn = drawn_of(*mesh);
  constexpr double margin = 1.0 / 64;  // the rasterizer's grid
  int decided = 0, covered = 0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      double surely = std::numeric_limits<double>::infinity(), perhaps = surely;
      for (const Drawn& triangle : drawn) {
        const double how = inside(triangle.corners, {x + 0.5, y + 0.5});
        if (how > margin) surely = std::min(surely, triangle.depth);
        if (how > -margin) perhaps = std::min(perhaps, triangle.depth);
      }
      if (surely != perhaps) continue;  // an edge goes by
      ++decided;
      if (std::isinf(surely)) {
        EXPECT_TRUE(std::isinf(depth.at(x, y))) << x << ", " << y;
      } else {
        EXPECT_NEAR(depth.at(x, y), surely, 1e-4) << x << ", " << y;
        ++covered;
      }
    }
  EXPECT_GT(decided, size * size / 2);
  EXPECT_GT(covered, size * size / 10);
}

/// Triangles of a pixel at the equator, and of next to nothing at the poles and toward the silhouette.
TEST(SmallTriangles, LeaveNoHoleInASphere) {
  Scene scene({48, 48});
  scene.surface("ball", lumen::testing::sphere(600));
  const Pixels depth = scene.layer("depth");
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 48; ++x) {
      const float u = (float(x) + 0.5f) * 2.2f / 48 - 1.1f, v = (float(y) + 0.5f) * 2.2f / 48 - 1.1f, square = u * u + v * v;
      if (square < 0.98f) {
        EXPECT_NEAR(depth.at(x, y), 10 - std::sqrt(1 - square), 2e-3f) << x << ", " << y;
      } else if (square > 1.001f) {
        EXPECT_TRUE(std::isinf(depth.at(x, y))) << x << ", " << y;
      }
    }
}

}  // namespace
