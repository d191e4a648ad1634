/// How much a picture differs from a reference: root mean square, largest, and structural difference.
/// Wang, Bovik, Sheikh, Simoncelli, Image Quality Assessment: From Error Visibility to Structural Similarity, TIP 2004.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <lumen/image.h>

struct Difference {
  double rmse = 0;             ///< over all pixels that count and their color channels
  double largest = 0;
  double structural = 0;       ///< 1 - mean structural similarity of the luminance; 0 = alike
  std::vector<float> map;      ///< per pixel, rows top-down: the largest of its channels' differences; 0 where it does not count
};

namespace difference_detail {

/// The mean over a Gaussian window of 11 x 11 pixels, sigma 1.5, as the paper takes; at the border over what is there.
inline std::vector<double> windowed(const std::vector<double>& values, int width, int height) {
  constexpr int reach = 5;
  std::array<double, 2 * reach + 1> weights;
  for (int i = -reach; i <= reach; ++i) weights[std::size_t(i + reach)] = std::exp(-i * i / (2 * 1.5 * 1.5));
  const auto along = [&](const std::vector<double>& from, int count, int lines, std::size_t step, std::size_t line_step) {
    std::vector<double> to(from.size());
    for (int line = 0; line < lines; ++line)
      for (int at = 0; at < count; ++at) {
        double sum = 0, total = 0;
        for (int i = std::max(-reach, -at); i <= std::min(reach, count - 1 - at); ++i) {
          const double weight = weights[std::size_t(i + reach)];
          sum += weight * from[std::size_t(line) * line_step + std::size_t(at + i) * step];
          total += weight;
        }
        to[std::size_t(line) * line_step + std::size_t(at) * step] = sum / total;
      }
    return to;
  };
  return along(along(values, width, height, 1, std::size_t(width)), height, width, std::size_t(width), 1);
}

/// Relative luminance of linear RGB, or the only channel; clamped to 0..1 and encoded as eyes see it.
inline std::vector<double> lightness(const lumen::Image& image, std::size_t channels) {
  std::vector<double> result(std::size_t(image.width) * std::size_t(image.height));
  const std::size_t stride = image.channels.size();
  for (std::size_t i = 0; i < result.size(); ++i) {
    const float* pixel = image.pixels.data() + i * stride;
    const double linear = channels < 3 ? double(pixel[0]) : 0.2126 * double(pixel[0]) + 0.7152 * double(pixel[1]) + 0.0722 * double(pixel[2]);
    result[i] = std::pow(std::clamp(linear, 0.0, 1.0), 1 / 2.2);
  }
  return result;
}

}  // namespace difference_detail

/// Pictures of one size; alpha does not count. `counts`: which pixels do, one per pixel, at least one.
inline Difference difference(const lumen::Image& picture, const lumen::Image& reference, const std::vector<bool>& counts) {
  using namespace difference_detail;
  Difference result;
  const std::size_t stride = picture.channels.size(), channels = std::min<std::size_t>(stride, 3), pixels = counts.size();
  result.map.resize(pixels);
  double squares = 0;
  std::size_t counted = 0;
  for (std::size_t i = 0; i < pixels; ++i) {
    if (!counts[i]) continue;
    ++counted;
    for (std::size_t c = 0; c < channels; ++c) {
      const double off = std::abs(double(picture.pixels[i * stride + c]) - double(reference.pixels[i * stride + c]));
      squares += off * off;
      result.map[i] = std::max(result.map[i], float(off));
    }
    result.largest = std::max(result.largest, double(result.map[i]));
  }
  if (counted == 0) return result;
  result.rmse = std::sqrt(squares / double(counted * channels));

  const int width = picture.width, height = picture.height;
  const std::vector<double> a = lightness(picture, channels), b = lightness(reference, channels);
  const auto product = [&](const std::vector<double>& x, const std::vector<double>& y) {
    std::vector<double> both(pixels);
    for (std::size_t i = 0; i < pixels; ++i) both[i] = x[i] * y[i];
    return windowed(both, width, height);
  };
  const std::vector<double> mean_a = windowed(a, width, height), mean_b = windowed(b, width, height);
  const std::vector<double> aa = product(a, a), bb = product(b, b), ab = product(a, b);
  constexpr double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;
  double similarity = 0;
  for (std::size_t i = 0; i < pixels; ++i) {
    if (!counts[i]) continue;
    const double means = mean_a[i] * mean_b[i], mean_squares = mean_a[i] * mean_a[i] + mean_b[i] * mean_b[i];
    similarity += (2 * means + c1) * (2 * (ab[i] - means) + c2) / ((mean_squares + c1) * (aa[i] + bb[i] - mean_squares + c2));
  }
  result.structural = 1 - similarity / double(counted);
  return result;
}
