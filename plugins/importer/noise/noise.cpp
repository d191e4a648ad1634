/// A picture of smooth noise: a background with structure, or a texture to try things on.
/// Lattice noise with octaves after Perlin, An Image Synthesizer, SIGGRAPH 1985.

#include <cmath>

#include <lumen/image.h>
#include <lumen/importer.h>

namespace {

/// 0..1, the same for the same corner and seed. Jarzynski, Olano, Hash Functions for GPU Rendering, JCGT 2020 (pcg3d).
float corner(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  x = x * 1664525u + 1013904223u, y = y * 1664525u + 1013904223u, z = z * 1664525u + 1013904223u;
  for (int round = 0; round < 2; ++round) {
    x += y * z, y += z * x, z += x * y;
    x ^= x >> 16u, y ^= y >> 16u, z ^= z >> 16u;
  }
  return float(x >> 8u) / 16777216.0f;
}

/// Smoothly interpolated between the corners of the unit lattice, which repeats after `period` cells.
float value_noise(glm::vec2 at, int period, int seed) {
  const glm::ivec2 cell(glm::floor(at));
  const glm::vec2 f = at - glm::vec2(cell), s = f * f * (3.0f - 2.0f * f);
  const auto number = [&](int dx, int dy) { return corner(std::uint32_t((cell.x + dx) % period), std::uint32_t((cell.y + dy) % period), std::uint32_t(seed)); };
  return glm::mix(glm::mix(number(0, 0), number(1, 0), s.x), glm::mix(number(0, 1), number(1, 1), s.x), s.y);
}

struct Noise : lumen::Importer {
  using Importer::Importer;

  lumen::Property<int> size{this, "size", 256, {.min = 1, .max = 4096, .unit = "pixels", .doc = "width and height", .logarithmic = true}};
  lumen::Property<int> cells{this, "cells", 8, {.min = 1, .max = 256, .doc = "bumps along a side, in the coarsest octave", .logarithmic = true}};
  lumen::Property<int> octaves{this, "octaves", 4, {.min = 1, .max = 8, .doc = "layers of noise, each twice as fine and half as strong"}};
  lumen::Property<int> seed{this, "seed", 1, {.min = 0, .max = 1000000, .doc = "which noise: the same number gives the same picture"}};
  lumen::Property<lumen::Color> dark{this, "dark", {0.2f, 0.2f, 0.2f}, {.min = 0, .max = 1, .doc = "color of the valleys"}};
  lumen::Property<lumen::Color> bright{this, "bright", {0.8f, 0.8f, 0.8f}, {.min = 0, .max = 1, .doc = "color of the hills"}};

  lumen::Output<lumen::Image> image{this, "image", {.doc = "the picture; it repeats without a seam"}};

  void compute(lumen::Job& job) const override {
    auto result = std::make_shared<lumen::Image>();
    result->origin = "noise";
    result->width = result->height = job[size];
    result->channels = {"R", "G", "B"};
    std::vector<float> pixels;
    pixels.reserve(std::size_t(job[size]) * std::size_t(job[size]) * 3);
    for (int y = 0; y < job[size]; ++y) {
      for (int x = 0; x < job[size]; ++x) {
        float sum = 0, weights = 0, weight = 1;
        for (int octave = 0; octave < job[octaves]; ++octave, weight *= 0.5f) {
          const int period = job[cells] << octave;
          sum += weight * value_noise((glm::vec2(x, y) + 0.5f) * (float(period) / float(job[size])), period, job[seed] + octave);
          weights += weight;
        }
        const glm::vec3 color = glm::mix(job[dark].rgb, job[bright].rgb, sum / weights);
        pixels.insert(pixels.end(), {color.r, color.g, color.b});
      }
      job.progress(float(y + 1) / float(job[size]));
    }
    result->pixels = std::move(pixels);
    result->finish();
    job.set(image, result);
  }
};

}  // namespace

LUMEN_PLUGIN(Noise, "importer.noise", "a picture of smooth noise that repeats without a seam")
