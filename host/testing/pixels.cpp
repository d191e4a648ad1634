/// Pixels of lumen/testing.h.
#include <lumen/testing.h>

#include <algorithm>
#include <cmath>

namespace lumen::testing {

Pixels::Pixels(std::shared_ptr<const Image> image) : image_(std::move(image)) {}

float Pixels::at(int x, int y, int channel) const {
  if (x < 0 || y < 0 || channel < 0 || x >= width() || y >= height() || channel >= channels())
    throw Error("pixel " + std::to_string(x) + ", " + std::to_string(y) + ", channel " + std::to_string(channel),
                "outside of " + image_->summary());
  return image_->pixels[(std::size_t(y) * width() + x) * channels() + channel];
}

glm::vec3 Pixels::rgb(int x, int y) const {
  glm::vec3 color(0);
  for (int channel = 0; channel < std::min(channels(), 3); ++channel) color[channel] = at(x, y, channel);
  return color;
}

glm::vec4 Pixels::rgba(int x, int y) const { return {rgb(x, y), channels() > 3 ? at(x, y, 3) : 1.0f}; }

float largest_difference(const Pixels& a, const Pixels& b) {
  if (a.width() != b.width() || a.height() != b.height() || a.channels() != b.channels())
    throw Error("pictures", "of different sizes: " + a.image().summary() + " and " + b.image().summary());
  float largest = 0;
  for (std::size_t i = 0; i < a.image().pixels.size(); ++i) {
    const float x = a.image().pixels[i], y = b.image().pixels[i];
    if (x == y) continue;  // infinite depths, too
    const float difference = std::abs(x - y);
    largest = std::isnan(difference) ? INFINITY : std::max(largest, difference);
  }
  return largest;
}

}  // namespace lumen::testing
