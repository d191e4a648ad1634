/// The checks that finish() of all data shares.
#include <checks/data_check.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <set>

#include <lumen/error.h>

namespace lumen::detail {

std::string name_of_origin(const Data& data) { return data.origin.empty() ? std::string(name_of(data.kind())) : data.origin; }

void check_finite(const Data& data, std::span<const float> numbers, std::string_view what) {
  // Infinities and NaN alone have an exponent of ones, which a one more in its place carries over into the sign.
  std::uint32_t carried = 0;
  for (const float number : numbers) carried |= (std::bit_cast<std::uint32_t>(number) & 0x7fffffffu) + 0x00800000u;
  if (carried >> 31 == 0) return;
  std::size_t index = 0;
  while (std::isfinite(numbers[index])) ++index;
  throw Error(name_of_origin(data), std::string(what) + " hold a number that is not finite (number " + std::to_string(index) + ")");
}

Bounds checked_bounds(const Data& data, const Array<glm::vec3>& positions) {
  if (positions.size() > std::numeric_limits<std::uint32_t>::max())
    throw Error(name_of_origin(data), grouped(positions.size()) + " points are more than 32-bit indices reach");
  check_finite(data, numbers_of(positions), "positions");
  // Four points at a time: twelve lanes that do not wait for each other.
  constexpr std::size_t width = 12;
  const std::span<const float> numbers = numbers_of(positions);
  std::array<float, width> low, high;
  low.fill(std::numeric_limits<float>::infinity());
  high.fill(-std::numeric_limits<float>::infinity());
  std::size_t index = 0;
  for (; index + width <= numbers.size(); index += width)
    for (std::size_t lane = 0; lane < width; ++lane) {
      const float number = numbers[index + lane];
      low[lane] = number < low[lane] ? number : low[lane];
      high[lane] = number > high[lane] ? number : high[lane];
    }
  Bounds bounds;
  for (; index < numbers.size(); index += 3) bounds.include(positions[index / 3]);
  for (std::size_t lane = 0; lane < width; lane += 3) {
    bounds.min = glm::min(bounds.min, glm::vec3(low[lane], low[lane + 1], low[lane + 2]));
    bounds.max = glm::max(bounds.max, glm::vec3(high[lane], high[lane + 1], high[lane + 2]));
  }
  return bounds;
}

void check_attributes(const Data& data, const std::vector<Attribute>& attributes, std::size_t points, std::size_t cells, bool exact_cells) {
  std::set<std::pair<bool, std::string_view>> names;
  for (const Attribute& attribute : attributes) {
    const bool on_points = attribute.on == Attribute::On::points;
    const auto fail = [&](const std::string& what) { throw Error(name_of_origin(data), "array '" + attribute.name + "' " + what); };
    if (attribute.name.empty()) fail("has no name");
    if (!names.emplace(on_points, attribute.name).second) fail("is there twice");
    if (attribute.components < 1 || attribute.components > 16)
      fail("has " + std::to_string(attribute.components) + " components; 1 to 16 are possible");
    const auto components = static_cast<std::size_t>(attribute.components);
    const std::size_t tuples = attribute.values.size() / components;
    const std::size_t wanted = on_points ? points : cells;
    const bool fits = on_points || exact_cells ? tuples == wanted : tuples >= wanted;
    if (attribute.values.size() % components != 0 || !fits)
      fail("has " + grouped(attribute.values.size()) + " numbers for " + grouped(wanted) + (on_points ? " points" : " cells") + " of " +
           std::to_string(components) + " components");
  }
}

std::size_t bytes_of(const std::vector<Attribute>& attributes) {
  std::size_t bytes = 0;
  for (const Attribute& attribute : attributes) bytes += attribute.values.view().size_bytes();
  return bytes;
}

}  // namespace lumen::detail
