/// Antialiased strokes and dots on a part of a picture: how much they cover each pixel, and their dark margin.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <lumen/gl/texture.h>

class Ink {
 public:
  explicit Ink(glm::ivec2 size) : size_(size), ink_(std::size_t(size.x) * std::size_t(size.y) * 2) {}

  /// Pixels, origin bottom left.
  void stroke(glm::vec2 a, glm::vec2 b, float width) {
    const glm::vec2 path = b - a;
    const float squared = glm::dot(path, path);
    draw(glm::min(a, b), glm::max(a, b), 0.5f * width, [&](glm::vec2 at) {
      const float along = squared > 0 ? std::clamp(glm::dot(at - a, path) / squared, 0.0f, 1.0f) : 0.0f;
      return glm::distance(at, a + along * path);
    });
  }
  void dot(glm::vec2 center, float radius) {
    draw(center, center, radius, [&](glm::vec2 at) { return glm::distance(at, center); });
  }
  /// Red: the strokes; green: their margin, which keeps them visible over bright pictures.
  void upload(const lumen::gl::Texture& texture) const { texture.upload(ink_.data()); }

 private:
  static constexpr float margin = 1;  // pixels

  template <class Distance>
  void draw(glm::vec2 low, glm::vec2 high, float reach, Distance distance) {
    const glm::ivec2 first = glm::max(glm::ivec2(glm::floor(glm::clamp(low, -1e6f, 1e6f) - reach - margin - 1.0f)), 0);
    const glm::ivec2 end = glm::min(glm::ivec2(glm::ceil(glm::clamp(high, -1e6f, 1e6f) + reach + margin + 1.0f)), size_);
    for (int y = first.y; y < end.y; ++y)
      for (int x = first.x; x < end.x; ++x) {
        const float away = distance(glm::vec2(x, y) + 0.5f);
        float* pixel = &ink_[2 * (std::size_t(y) * std::size_t(size_.x) + std::size_t(x))];
        pixel[0] = std::max(pixel[0], std::clamp(reach + 0.5f - away, 0.0f, 1.0f));
        pixel[1] = std::max(pixel[1], 0.5f * std::clamp(reach + margin + 0.5f - away, 0.0f, 1.0f));
      }
  }

  glm::ivec2 size_;
  std::vector<float> ink_;
};
