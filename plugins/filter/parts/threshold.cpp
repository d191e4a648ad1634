#include "threshold.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

std::optional<float> dividing_thickness(std::span<const float> values, std::span<const float> weights, float least) {
  float low = std::numeric_limits<float>::max(), high = 0;
  for (const float value : values)
    if (value > 0) low = std::min(low, value), high = std::max(high, value);
  if (!(high > low)) return std::nullopt;

  constexpr std::size_t count = 512;
  const double first = std::log(double(low)), width = (std::log(double(high)) - first) / count;
  struct Bin {
    double weight = 0, sum = 0;
  };
  std::array<Bin, count> bins;
  Bin all;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!(values[i] > 0)) continue;
    const double logarithm = std::log(double(values[i])), weight = weights[i];
    Bin& bin = bins[std::min(std::size_t(std::max(0.0, (logarithm - first) / width)), count - 1)];
    bin.weight += weight, bin.sum += weight * logarithm;
    all.weight += weight, all.sum += weight * logarithm;
  }
  double best = 0, apart = 0;
  std::size_t begin = 0, end = 0;  // bins between which all divisions are equally good
  Bin below;
  for (std::size_t i = 0; i + 1 < count; ++i) {
    below.weight += bins[i].weight, below.sum += bins[i].sum;
    const Bin above{all.weight - below.weight, all.sum - below.sum};
    if (!(below.weight > 0 && above.weight > 0)) continue;
    const double difference = above.sum / above.weight - below.sum / below.weight, between = below.weight * above.weight * difference * difference;
    if (between > best) best = between, apart = difference, begin = i;
    if (between >= best) end = i;
  }
  if (apart < std::log(double(least))) return std::nullopt;
  return float(std::exp(first + width * (0.5 * double(begin + end) + 1)));
}
