/// Scenes of transparent sheets whose picture is known: what every transparency technique is measured against.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <lumen/testing.h>

namespace sheets {

using lumen::testing::Pixels;
using lumen::testing::Scene;

/// A rectangle that shows its color as it is, in a plane z = height + slope . xy.
struct Sheet {
  float height = 0;
  glm::vec3 color{1};
  float alpha = 0.5f;
  glm::vec2 slope{0};
};

/// One fragment as the reference sees it.
struct Layer {
  float z;
  glm::vec3 color;
  float alpha;
};

/// Associated color and opacity of the layers, the one with the largest z in front; equal ones in their order here.
inline glm::vec4 composited(std::vector<Layer> layers) {
  std::stable_sort(layers.begin(), layers.end(), [](const Layer& a, const Layer& b) { return a.z > b.z; });
  glm::dvec3 color(0);
  double transmittance = 1;
  for (const Layer& layer : layers) {
    color += transmittance * double(layer.alpha) * glm::dvec3(layer.color);
    transmittance *= 1 - double(layer.alpha);
  }
  return glm::vec4(color, 1 - transmittance);
}

inline std::string text(float value) { return std::to_string(value); }
inline std::string text(glm::vec3 v) { return "[" + text(v.x) + "," + text(v.y) + "," + text(v.z) + "]"; }

/// The matrix, by rows, that takes z = 0 to the sheet's plane.
inline std::string transform_of(const Sheet& sheet) {
  return "[1,0,0,0, 0,1,0,0, " + text(sheet.slope.x) + "," + text(sheet.slope.y) + ",1," + text(sheet.height) + ", 0,0,0,1]";
}

/// Adds the sheets in this order, each with an opacity of its own. The scene's camera sees nothing but them.
inline void add(Scene& scene, const std::vector<Sheet>& list) {
  scene.add("ambient.constant", "ambient");
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string number = std::to_string(i);
    scene.add("opacity.constant", "alpha" + number, R"({"alpha": )" + text(list[i].alpha) + "}");
    scene.surface("sheet" + number, lumen::testing::rectangle(3, 3),
                  R"({"ambient": "ambient", "opacity": "alpha)" + number + R"(", "ambient_color": )" + text(list[i].color) + R"(, "transform": )" + transform_of(list[i]) + "}");
  }
}

/// World position of a pixel's center in the scene's first camera.
inline glm::vec2 place_of(const Pixels& pixels, int x, int y) {
  const float pixel = 2.2f / float(pixels.height());
  return {(float(x) + 0.5f - 0.5f * float(pixels.width())) * pixel, (0.5f * float(pixels.height()) - float(y) - 0.5f) * pixel};
}

inline glm::vec4 expected_at(const std::vector<Sheet>& list, glm::vec2 place) {
  std::vector<Layer> layers;
  for (const Sheet& sheet : list) layers.push_back({sheet.height + glm::dot(sheet.slope, place), sheet.color, sheet.alpha});
  return composited(std::move(layers));
}

/// Sheets at distinct heights, in no order, with colors and opacities from a fixed seed.
inline std::vector<Sheet> shuffled(int count, unsigned seed, float alpha_max = 0.9f) {
  std::mt19937 random(seed);
  const auto uniform = [&] { return float(random() % 10000) / 10000; };
  std::vector<Sheet> list;
  for (int i = 0; i < count; ++i)
    list.push_back({.height = -1.0f + 2.0f * float(i) / float(count), .color = {uniform(), uniform(), uniform()}, .alpha = 0.02f + (alpha_max - 0.02f) * uniform()});
  std::shuffle(list.begin(), list.end(), random);
  return list;
}

/// The transparent layer differs from the sheets' true picture by at most this anywhere.
inline float largest_error(Scene& scene, const std::vector<Sheet>& list) {
  const Pixels pixels = scene.layer("transparent");
  float largest = 0;
  for (int y = 0; y < pixels.height(); ++y)
    for (int x = 0; x < pixels.width(); ++x) {
      const glm::vec4 wanted = expected_at(list, place_of(pixels, x, y));
      for (int c = 0; c < 4; ++c) {
        const float error = std::abs(pixels.at(x, y, c) - wanted[c]);
        if (std::isnan(error)) return error;
        largest = std::max(largest, error);
      }
    }
  return largest;
}

}  // namespace sheets
