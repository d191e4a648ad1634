/// opacity.contours on meshes with curvature: lines where the radial curvature of the implicit surface is 0, by brute force.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <glm/gtc/matrix_inverse.hpp>
#include <lumen/mesh.h>

#include "plugins/term_oracle.h"

namespace lumen::testing {
namespace {

constexpr double ring = 0.65, tube = 0.35;  // radii of the torus about z
constexpr glm::ivec2 size(240, 240);
constexpr double thickness = 2, cut_off = 3, angle = 20;

/// How a torus comes to the screen: x -> turn * matrix * x, seen along -z from a distance.
struct Sight {
  glm::mat4 matrix{1};
  glm::quat turn{1, 0, 0, 0};
  bool perspective = false;
  double distance = 10, field_of_view = 65;
};

/// A point of the moved torus; what turns about the normal is computed from the implicit surface, as double.
struct Place {
  glm::dvec3 position, along;  ///< view space; along: the view direction within the surface
  glm::dvec2 pixel;
  double facing, curvature;    ///< cosine to the eye; radial curvature
};

class Torus {
 public:
  explicit Torus(const Sight& sight) : sight_(sight), matrix_(glm::dmat3(glm::mat3_cast(sight.turn)) * glm::dmat3(glm::mat3(sight.matrix))), inverse_(glm::inverse(matrix_)) {}

  Place at(double u, double v) const {
    const glm::dvec3 x((ring + tube * std::cos(v)) * std::cos(u), (ring + tube * std::cos(v)) * std::sin(u), tube * std::sin(v));
    // (|(x, y)| - ring)^2 + z^2 - tube^2 = 0
    const double from_axis = std::hypot(x.x, x.y), cube = std::pow(from_axis, 3), shrink = 1 - ring / from_axis;
    const glm::dvec3 gradient = 2.0 * glm::dvec3(x.x * shrink, x.y * shrink, x.z);
    const double xy = ring * x.x * x.y / cube;
    const glm::dmat3 hessian = 2.0 * glm::dmat3(shrink + ring * x.x * x.x / cube, xy, 0, xy, shrink + ring * x.y * x.y / cube, 0, 0, 0, 1);
    const glm::dvec3 moved_gradient = glm::transpose(inverse_) * gradient;
    const glm::dmat3 moved_hessian = glm::transpose(inverse_) * hessian * inverse_;

    Place place;
    place.position = matrix_ * x - glm::dvec3(0, 0, sight_.distance);
    const glm::dvec3 normal = glm::normalize(moved_gradient), to_eye = sight_.perspective ? -glm::normalize(place.position) : glm::dvec3(0, 0, 1);
    place.facing = glm::dot(normal, to_eye);
    place.along = to_eye - place.facing * normal;
    place.curvature = glm::dot(place.along, moved_hessian * place.along) / glm::length(moved_gradient) / glm::dot(place.along, place.along);
    const double half = sight_.perspective ? -place.position.z * std::tan(glm::radians(sight_.field_of_view) / 2) : 1.1;
    place.pixel = 0.5 * glm::dvec2(size) * (1.0 + glm::dvec2(place.position.x, -place.position.y) / half) - 0.5;
    return place;
  }
  /// The scene's radius.
  double radius() const {
    Bounds bounds;
    bounds.include(glm::vec3(-1, -1, -tube));
    bounds.include(glm::vec3(1, 1, tube));
    return bounds.transformed(sight_.matrix).radius();
  }

 private:
  Sight sight_;
  glm::dmat3 matrix_, inverse_;
};

/// Where lines may be, and where they must be.
struct Expected {
  std::vector<char> allowed = std::vector<char>(std::size_t(size.x) * std::size_t(size.y));
  std::vector<glm::dvec2> certain;

  static void mark(std::vector<char>& pixels, glm::dvec2 center, double reach) {
    for (int y = std::max(0, int(center.y - reach)); y <= std::min(size.y - 1, int(center.y + reach) + 1); ++y)
      for (int x = std::max(0, int(center.x - reach)); x <= std::min(size.x - 1, int(center.x + reach) + 1); ++x)
        if (glm::length(glm::dvec2(x, y) - center) <= reach) pixels[std::size_t(y * size.x + x)] = 1;
  }
};

Expected expected(const Torus& torus) {
  constexpr int columns = 1200, rows = 500;
  std::vector<Place> places;
  for (int i = 0; i <= columns; ++i)
    for (int j = 0; j <= rows; ++j) places.push_back(torus.at(2 * std::numbers::pi * i / columns, 2 * std::numbers::pi * j / rows));
  Expected result;
  const double square = torus.radius() * torus.radius();
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      const Place &here = places[std::size_t(i * (rows + 1) + j)], &right = places[std::size_t((i + 1) * (rows + 1) + j)], &up = places[std::size_t(i * (rows + 1) + j + 1)];
      for (const Place* other : {&right, &up}) {
        if (here.facing <= 0 || (here.curvature > 0) == (other->curvature > 0)) continue;
        // along = a * (right - here) + b * (up - here), along which the curvature grows.
        const glm::dvec3 u = right.position - here.position, v = up.position - here.position;
        const double uu = glm::dot(u, u), uv = glm::dot(u, v), vv = glm::dot(v, v), wu = glm::dot(here.along, u), wv = glm::dot(here.along, v), d = uu * vv - uv * uv;
        const double growth = square * ((vv * wu - uv * wv) / d * (right.curvature - here.curvature) + (uu * wv - uv * wu) / d * (up.curvature - here.curvature)) / glm::length(here.along);
        const double slope = glm::degrees(std::acos(here.facing));
        const glm::dvec2 pixel = glm::mix(here.pixel, other->pixel, here.curvature / (here.curvature - other->curvature));
        // From one pixel to the next the growth changes by about the cut-off.
        if (growth > -cut_off && slope > angle - 2) Expected::mark(result.allowed, pixel, 1.5 + thickness / 2);
        if (growth > 2.3 * cut_off && slope > angle + 12) result.certain.push_back(pixel);
      }
    }
  return result;
}

/// The torus, or its triangles turned inside out, with curvature and lines.
class Lines {
 public:
  explicit Lines(const Sight& sight, bool inside_out = false) : scene(size) {
    scene.add("importer.shape", "shape", R"({"shape": "torus", "tube": 0.35, "detail": 320})");
    scene.add("filter.curvature", "bent", R"({"mesh": {"link": "shape.mesh"}})");
    scene.add("renderer.surface", "torus", R"({"mesh": {"link": "bent.result"}, "opacity": "term"})");
    scene.add("opacity.contours", "term", R"({"alpha_min": 0, "thickness": 2, "cut_off": 3, "angle": 20})");
    scene.add("transparency.weighted", "weighted");
    if (inside_out) turn_inside_out();
    look(sight);
  }
  void look(const Sight& sight) {
    scene.set_value("torus.transform", sight.matrix);
    scene.set_value("camera.rotation", sight.turn);
    if (sight.perspective) look_from_near(scene, float(sight.distance));
  }
  Scene scene;

 private:
  /// Its triangles, its normals, and its curvature, which is about them.
  void turn_inside_out() {
    scene.layer("opacity");
    const auto mesh = std::make_shared<Mesh>(dynamic_cast<const Mesh&>(*std::get<DataPointer>(scene.value("bent.result"))));
    std::vector<glm::uvec3> triangles;
    for (const glm::uvec3& t : mesh->triangles) triangles.emplace_back(t.x, t.z, t.y);
    std::vector<glm::vec3> normals;
    for (const glm::vec3& normal : mesh->normals) normals.push_back(-normal);
    for (Attribute& attribute : mesh->attributes) {
      std::vector<float> values;
      for (const float value : attribute.values) values.push_back(-value);
      attribute.values = std::move(values);
    }
    mesh->triangles = std::move(triangles);
    mesh->normals = std::move(normals);
    mesh->finish();
    scene.give("turned", mesh);
    scene.set("torus.mesh", R"({"link": "turned.mesh"})");
  }
};

void expect_lines(Lines& lines, const Sight& sight) {
  const Expected wanted = expected(Torus(sight));
  const Pixels opacity = lines.scene.layer("opacity");
  lines.scene.set("term.suggestive", "0");
  const Pixels contours = lines.scene.layer("opacity");
  lines.scene.set("term.suggestive", "1");
  std::string strays;
  int drawn = 0, missing = 0, due = 0;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const auto pixel = std::size_t(y * size.x + x);
      if (opacity.at(x, y) - contours.at(x, y) <= 0.3f) continue;
      ++drawn;
      if (!wanted.allowed[pixel]) strays += " " + std::to_string(x) + "," + std::to_string(y);
    }
  for (const glm::dvec2& point : wanted.certain) {
    const glm::ivec2 center(glm::round(point));
    if (center.x < 1 || center.y < 1 || center.x > size.x - 2 || center.y > size.y - 2) continue;
    float most = 0;
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) most = std::max(most, opacity.at(center.x + x, center.y + y));
    ++due;
    missing += most <= 0.5f;
  }
  EXPECT_EQ(strays, "") << "of " << drawn << " pixels";
  EXPECT_EQ(missing, 0) << "of " << due;
  EXPECT_GT(drawn, 60);
  EXPECT_GT(due, 100);
  EXPECT_TRUE(lines.scene.problems().empty());
}

glm::quat tilted(float degrees) { return glm::angleAxis(glm::radians(-degrees), glm::normalize(glm::vec3(1, 0.2f, 0))); }

TEST(SuggestiveContours, AreWhereTheRadialCurvatureVanishesAndSlideWithTheCamera) {
  Lines lines({.turn = tilted(62)});
  expect_lines(lines, {.turn = tilted(62)});
  const Pixels before = lines.scene.layer("opacity");
  lines.look({.turn = tilted(72)});
  expect_lines(lines, {.turn = tilted(72)});
  EXPECT_GT(largest_difference(before, lines.scene.layer("opacity")), 0.9f);
}

TEST(SuggestiveContours, AreRightInPerspective) {
  const Sight sight{.turn = tilted(62), .perspective = true, .distance = 2.2};
  Lines lines(sight);
  expect_lines(lines, sight);
}

TEST(SuggestiveContours, AreRightUnderAnyTransform) {
  // Scaled unevenly, sheared and mirrored: what turns into what is not a torus any more.
  const Sight sight{.matrix = glm::mat4(0.8f, 0.1f, 0, 0, -0.2f, 1.1f, 0, 0, 0.1f, 0.2f, -1.6f, 0, 0, 0, 0, 1), .turn = tilted(40)};
  ASSERT_LT(glm::determinant(sight.matrix), 0);
  Lines lines(sight);
  expect_lines(lines, sight);
}

TEST(SuggestiveContours, AreThoseOfTheOutsideWhereverTheMeshFaces) {
  const Sight sight{.turn = tilted(62)};
  Lines lines(sight, true);
  expect_lines(lines, sight);
}

TEST(SuggestiveContours, StayWhereColorsGiveEachTriangleItsOwnPoints) {
  Lines lines({.turn = tilted(62)});
  const Pixels shared = lines.scene.layer("opacity");
  const auto mesh = std::make_shared<Mesh>(dynamic_cast<const Mesh&>(*std::get<DataPointer>(lines.scene.value("bent.result"))));
  mesh->attributes.push_back({"number", Attribute::On::cells, 1, std::vector<float>(mesh->triangles.size(), 1.0f)});
  mesh->finish();
  lines.scene.give("colored", mesh);
  lines.scene.set("torus.mesh", R"({"link": "colored.mesh"})");
  lines.scene.set("torus.color_by", "number");
  EXPECT_LT(largest_difference(shared, lines.scene.layer("opacity")), 1e-4f);
  EXPECT_TRUE(lines.scene.problems().empty());
}

TEST(SuggestiveContours, ABallHasNone) {
  Scene scene({120, 120});
  scene.give("shape", sphere(128));
  scene.add("filter.curvature", "bent", R"({"mesh": {"link": "shape.mesh"}})");
  scene.add("renderer.surface", "ball", R"({"mesh": {"link": "bent.result"}, "opacity": "term"})");
  scene.add("opacity.contours", "term", R"({"alpha_min": 0, "thickness": 2, "cut_off": 0.01, "angle": 0})");
  scene.add("transparency.weighted", "weighted");
  for (const bool near : {false, true}) {
    if (near) look_from_near(scene, 3);
    const Pixels opacity = scene.layer("opacity");
    const double center = 59.5, half = near ? 3 * std::tan(glm::radians(32.5)) : 1.1, edge = 60 / half * (near ? 3 / std::sqrt(8.0) : 1);
    int ring_pixels = 0;
    for (int y = 0; y < 120; ++y)
      for (int x = 0; x < 120; ++x) {
        const bool inside = std::hypot(x - center, y - center) < edge - 4;
        ASSERT_TRUE(!inside || opacity.at(x, y) == 0) << x << ", " << y;
        ring_pixels += opacity.at(x, y) > 0.9f;
      }
    EXPECT_GT(ring_pixels, 200);
  }
}

TEST(SuggestiveContours, WithoutCurvatureANoteSaysWhereItComesFrom) {
  Lines lines({.turn = tilted(62)});
  lines.scene.set("torus.mesh", R"({"link": "shape.mesh"})");
  lines.scene.layer("opacity");
  const auto problems = lines.scene.problems();
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems.front().severity, Severity::note);
  EXPECT_EQ(problems.front().instance, "torus");
  EXPECT_NE(problems.front().message.find("link the mesh through filter.curvature"), std::string::npos) << problems.front().message;
  lines.scene.set("torus.mesh", R"({"link": "bent.result"})");
  lines.scene.layer("opacity");
  EXPECT_TRUE(lines.scene.problems().empty());
}

}  // namespace
}  // namespace lumen::testing
