/// Terms against formulas: a ball or a probe lit through the program's own path, and what a test compares its pixels with.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/gtx/quaternion.hpp>
#include <lumen/testing.h>

namespace lumen::testing {

constexpr float term_tolerance = 1e-4f;

struct TestLight {
  glm::vec3 direction{0, 0, 1};  ///< toward the light, unit
  glm::vec3 position{0};
  bool point = false;
  glm::vec3 color{1};
  std::function<float(float)> falloff = [](float) { return 1.0f; };
};

/// Where a term is evaluated: unit vectors in world space; the cameras of these tests look along -z.
struct Angles {
  glm::vec3 n, l, v;
  glm::vec3 halfway() const { return glm::normalize(l + v); }
};
/// What a term multiplies the light's radiance by, material included. NaN: not checked there, since the formula jumps.
using Reflectance = std::function<glm::vec3(const Angles&)>;

inline const glm::vec3 ambient_color(0.2f, 0.1f, 0.05f), diffuse_color(0.7f, 0.3f, 0.2f), specular_color(0.5f, 0.6f, 0.7f);
constexpr float shininess = 20;
inline const glm::vec3 slanted = glm::normalize(glm::vec3(0.4f, 0.5f, 0.6f));

inline std::string json(glm::vec3 v) { return "[" + std::to_string(v.x) + "," + std::to_string(v.y) + "," + std::to_string(v.z) + "]"; }

inline glm::vec3 lambert_term(const Angles& a) { return diffuse_color * std::max(0.0f, glm::dot(a.n, a.l)); }
inline glm::vec3 blinn_term(const Angles& a) { return specular_color * std::pow(std::max(0.0f, glm::dot(a.n, a.halfway())), shininess); }
inline glm::vec3 phong_term(const Angles& a) {
  return specular_color * std::pow(std::max(0.0f, glm::dot(2 * glm::dot(a.n, a.l) * a.n - a.l, a.v)), shininess);
}

/// "ball", a unit sphere with the terms "ambient" (constant), "diffuse" and "specular" and the colors above.
inline void add_ball(Scene& scene, const std::string& diffuse, const std::string& specular, const std::string& diffuse_properties = "{}",
                     const std::string& specular_properties = "{}") {
  scene.surface("ball", sphere(96),
                R"({"ambient": "ambient", "diffuse": "diffuse", "specular": "specular", "ambient_color": )" + json(ambient_color) +
                    R"(, "diffuse_color": )" + json(diffuse_color) + R"(, "specular_color": )" + json(specular_color) + R"(, "shininess": 20})");
  scene.add("ambient.constant", "ambient");
  scene.add(diffuse, "diffuse", diffuse_properties);
  scene.add(specular, "specular", specular_properties);
}

/// Brings the eye so near that its direction differs from pixel to pixel.
inline void look_from_near(Scene& scene, float distance = 2) {
  scene.set("camera.projection", "perspective");
  scene.set("camera.field_of_view", "65");
  scene.set("camera.distance", std::to_string(distance));
}

/// Compares all layers of the ball with the formulas, at every covered pixel.
inline void expect_closed_form(Scene& scene, const std::vector<TestLight>& lights, const Reflectance& diffuse_term, const Reflectance& specular_term) {
  const Pixels normal = scene.layer("normal"), position = scene.layer("position"), ambient = scene.layer("ambient"),
               diffuse = scene.layer("diffuse"), specular = scene.layer("specular"), color = scene.layer("color");
  const bool perspective = std::get<Choice>(scene.value("camera.projection")) == "perspective";
  const glm::vec3 eye(0, 0, std::get<float>(scene.value("camera.distance")));
  const auto expect_near = [](float value, float wanted, int x, int y, const char* layer) {
    if (std::isnan(wanted)) return;
    ASSERT_NEAR(value, wanted, term_tolerance * std::max(1.0f, std::abs(wanted))) << layer << " at " << x << ", " << y;
  };
  int covered = 0;
  for (int y = 0; y < normal.height(); ++y) {
    for (int x = 0; x < normal.width(); ++x) {
      const glm::vec3 n = normal.rgb(x, y);
      if (n == glm::vec3(0)) {
        ASSERT_EQ(color.rgba(x, y).a, 0) << "background at " << x << ", " << y;
        continue;
      }
      ++covered;
      const glm::vec3 place = position.rgb(x, y), v = perspective ? glm::normalize(eye - place) : glm::vec3(0, 0, 1);
      glm::vec3 wanted_diffuse(0), wanted_specular(0);
      for (const TestLight& light : lights) {
        const glm::vec3 path = light.point ? light.position - place : light.direction;
        const Angles angles{n, glm::normalize(path), v};
        const glm::vec3 radiance = light.color / (light.point ? light.falloff(glm::length(path)) : 1.0f);
        wanted_diffuse += radiance * diffuse_term(angles);
        if (glm::dot(n, angles.l) > 0) wanted_specular += radiance * specular_term(angles);
      }
      for (int c = 0; c < 3; ++c) {
        expect_near(ambient.at(x, y, c), ambient_color[c], x, y, "ambient");
        expect_near(diffuse.at(x, y, c), wanted_diffuse[c], x, y, "diffuse");
        expect_near(specular.at(x, y, c), wanted_specular[c], x, y, "specular");
        expect_near(color.at(x, y, c), ambient.at(x, y, c) + diffuse.at(x, y, c) + specular.at(x, y, c), x, y, "color");
      }
      if (::testing::Test::HasFatalFailure()) return;
    }
  }
  EXPECT_GT(covered, normal.width() * normal.height() / 2);
  EXPECT_TRUE(scene.problems().empty());
}

/// The formulas under every kind of light: several directions, from grazing to behind; two at once; points with each falloff;
/// each seen from far and from near.
inline void expect_closed_form_everywhere(const std::string& diffuse, const Reflectance& diffuse_term, const std::string& specular, const Reflectance& specular_term,
                                          const std::string& diffuse_properties = "{}", const std::string& specular_properties = "{}") {
  Scene scene({40, 40});
  add_ball(scene, diffuse, specular, diffuse_properties, specular_properties);
  for (const bool near : {false, true}) {
    if (near) look_from_near(scene);
    for (const glm::vec3 toward : {glm::vec3(0, 0, 1), slanted, glm::normalize(glm::vec3(1, 0.1f, 0.02f)), glm::normalize(glm::vec3(0.3f, -0.5f, -0.7f))}) {
      SCOPED_TRACE(diffuse + " " + diffuse_properties + ", " + specular + " " + specular_properties + ", light from " + json(toward) + (near ? ", seen from near" : ""));
      scene.set("front.direction", json(toward));
      expect_closed_form(scene, {{.direction = toward}}, diffuse_term, specular_term);
      if (::testing::Test::HasFatalFailure()) return;
    }
  }
  const glm::vec3 place(1.5f, 1, 2), other = glm::normalize(glm::vec3(-0.8f, -0.1f, 0.2f));
  scene.set("front.kind", "point");
  scene.set("front.position", json(place));
  scene.add("interactor.light", "back", R"({"direction": )" + json(other) + R"(, "color": [0.2, 0.4, 0.9], "intensity": 0.5})");
  const TestLight back{.direction = other, .color = 0.5f * glm::vec3(0.2f, 0.4f, 0.9f)};
  const std::pair<const char*, std::function<float(float)>> falloffs[] = {
      {"none", [](float) { return 1.0f; }}, {"linear", [](float d) { return d; }}, {"quadratic", [](float d) { return d * d; }}};
  for (const auto& [name, falloff] : falloffs) {
    SCOPED_TRACE(diffuse + ", " + specular + ", two lights, falloff " + name);
    scene.set("front.falloff", name);
    expect_closed_form(scene, {{.position = place, .point = true, .falloff = falloff}, back}, diffuse_term, specular_term);
    if (::testing::Test::HasFatalFailure()) return;
  }
}

/// One normal, one direction of view (+z), light from all over the hemisphere: a paraboloid around a point light at its focus, seen
/// from far, whose normals all are `normal`. A pixel at (x, y) is lit from the stereographic direction (-2x, -2y, 1 - r^2) / (1 + r^2),
/// so the sum of a layer over the pixels, times 4 / (1 + r^2)^2 and their area, is the integral over all directions of light.
class LightProbe {
 public:
  LightProbe(const std::string& layer, const std::string& type, const std::string& properties, glm::vec3 normal, float reach = 2.6f, int pixels = 260)
      : layer_(layer), normal_(normal), reach_(reach), scene_({pixels, pixels}) {
    auto mesh = std::make_shared<Mesh>();
    constexpr std::uint32_t cells = 320;
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;
    for (std::uint32_t row = 0; row <= cells; ++row)
      for (std::uint32_t column = 0; column <= cells; ++column) {
        const glm::vec2 at = 1.02f * reach * (2.0f * glm::vec2(column, row) / float(cells) - 1.0f);
        positions.emplace_back(at, (glm::dot(at, at) - 1) / 2);
        if (row == cells || column == cells) continue;
        const std::uint32_t a = row * (cells + 1) + column, b = a + cells + 1;
        triangles.emplace_back(a, a + 1, b + 1);
        triangles.emplace_back(a, b + 1, b);
      }
    mesh->normals = std::vector<glm::vec3>(positions.size(), normal);
    mesh->positions = std::move(positions);
    mesh->triangles = std::move(triangles);
    mesh->finish();
    scene_.set("camera.height", std::to_string(2 * reach));
    scene_.set("camera.distance", "30");
    scene_.set("front.kind", "point");
    scene_.set("front.position", "[0, 0, 0]");
    scene_.surface("probe", mesh, R"({")" + layer + R"(": "term", "diffuse_color": [1, 1, 1], "specular_color": [1, 1, 1]})");
    scene_.add(type, "term", properties);
  }
  void set(const std::string& property, const std::string& value) { scene_.set("term." + property, value); }

  /// The integral over all directions of light of what the term reflects, times what `factor` says of the angles.
  double integral(const std::function<double(const Angles&)>& factor = [](const Angles&) { return 1.0; }) {
    const Pixels pixels = scene_.layer(layer_);
    const double step = 2.0 * reach_ / pixels.width();
    double sum = 0;
    for (int y = 0; y < pixels.height(); ++y)
      for (int x = 0; x < pixels.width(); ++x) {
        const double value = pixels.at(x, y);
        if (value == 0) continue;
        const glm::dvec2 at((x + 0.5) * step - reach_, reach_ - (y + 0.5) * step);
        const double square = glm::dot(at, at), scale = 1 / (1 + square);
        const glm::vec3 light(glm::dvec3(-2.0 * at * scale, (1 - square) * scale));
        sum += value * factor({normal_, light, glm::vec3(0, 0, 1)}) * 4 * scale * scale * step * step;
      }
    EXPECT_TRUE(scene_.problems().empty());
    return sum;
  }

 private:
  std::string layer_;
  glm::vec3 normal_;
  float reach_;
  Scene scene_;
};

/// A white wall with normal +z that is lit and seen from any directions with z > 0.
class WallProbe {
 public:
  WallProbe(const std::string& layer, const std::string& type, const std::string& properties = "{}", const std::string& material = R"("diffuse_color": [1, 1, 1])")
      : layer_(layer), scene_({3, 3}) {
    scene_.surface("wall", rectangle(8, 8), R"({")" + layer + R"(": "term", "specular_color": [1, 1, 1], )" + material + "}");
    scene_.add(type, "term", properties);
  }
  void set(const std::string& property, const std::string& value) { scene_.set("term." + property, value); }
  glm::vec3 reflected(glm::vec3 toward_light, glm::vec3 toward_eye = {0, 0, 1}) {
    scene_.set("front.direction", json(toward_light));
    scene_.set_value("camera.rotation", glm::rotation(glm::normalize(toward_eye), glm::vec3(0, 0, 1)));
    return scene_.layer(layer_).rgb(1, 1);
  }

 private:
  std::string layer_;
  Scene scene_;
};

/// The direction in the x-z plane at this many degrees from +z.
inline glm::vec3 turned(float degrees) { return {std::sin(glm::radians(degrees)), 0, std::cos(glm::radians(degrees))}; }

}  // namespace lumen::testing
