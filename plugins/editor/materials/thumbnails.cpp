#include "thumbnails.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace {

constexpr int side = 128;            // pixels; drawn at up to that size
constexpr int taps = 3;              // per pixel and direction
constexpr int asked_at_once = 4;     // pictures that are being made

float encoded(float linear) {
  const float x = std::clamp(linear, 0.0f, 1.0f);
  return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f;
}

glm::vec3 texel(const lumen::Image& picture, glm::vec2 uv) {
  const int x = std::clamp(int(uv.x * float(picture.width)), 0, picture.width - 1), y = std::clamp(int((1 - uv.y) * float(picture.height)), 0, picture.height - 1);
  const std::size_t channels = picture.channels.size();
  const float* at = picture.pixels.data() + (std::size_t(y) * std::size_t(picture.width) + std::size_t(x)) * channels;
  return channels < 3 ? glm::vec3(at[0]) : glm::vec3(at[0], at[1], at[2]);
}

/// Rows bottom-up, sRGB, straight alpha.
std::vector<float> sphere_of(const lumen::Image& picture, bool equidistant) {
  std::vector<float> pixels;
  pixels.reserve(side * side * 4);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      glm::vec3 sum(0);
      int covered = 0;
      for (int tap = 0; tap < taps * taps; ++tap) {
        const glm::vec2 sample = glm::vec2(x, y) + (glm::vec2(tap % taps, tap / taps) + 0.5f) / float(taps);
        const glm::vec2 place = 2.0f * sample / float(side) - 1.0f;
        const float distance = glm::length(place);
        if (distance > 1) continue;
        const float radius = equidistant && distance > 0 ? 2 * std::asin(distance) / std::numbers::pi_v<float> / distance : 1.0f;
        sum += texel(picture, 0.5f + 0.5f * radius * place);
        ++covered;
      }
      const glm::vec3 color = covered > 0 ? sum / float(covered) : glm::vec3(0);
      pixels.insert(pixels.end(), {encoded(color.r), encoded(color.g), encoded(color.b), float(covered) / (taps * taps)});
    }
  return pixels;
}

}  // namespace

const Thumbnails::Entry& Thumbnails::of(lumen::Workbench& workbench, const Material& material) {
  // A small picture is enough where its size can be asked for.
  const std::string values = material.json(material.type == "importer.lit_sphere" ? "\"size\": 256" : "");
  Entry& entry = entries_[material.type + values];
  if (entry.texture || !entry.failure.empty() || asked_ >= asked_at_once) return entry;
  ++asked_;
  try {
    const auto picture = workbench.picture(material.type, values);
    if (!picture) return entry;
    --asked_;
    entry.texture = lumen::gl::Texture(lumen::Format::RGBA8, {side, side});
    entry.texture.linear();
    entry.texture.upload(sphere_of(*picture, material.equidistant).data());
  } catch (const lumen::Error& error) {
    entry.failure = error.what();
  }
  return entry;
}
