/// The checks that finish() of all data shares.
#include <checks/data_check.h>

#include <cmath>
#include <limits>
#include <set>

#include <lumen/error.h>

namespace lumen::detail {

std::string name_of_origin(const Data& data) { return data.origin.empty() ? std::string(name_of(data.kind())) : data.origin; }

void check_finite(const Data& data, std::span<const float> numbers, std::string_view what) {
  // x * 0 is NaN for infinities and NaN, else 0: one pass without branches. Four sums, as one would wait for itself.
  float sums[4] = {0, 0, 0, 0};
  std::size_t index = 0;
  for (; index + 4 <= numbers.size(); index += 4)
    for (int lane = 0; lane < 4; ++lane) sums[lane] += numbers[index + lane] * 0.0f;
  for (; index < numbers.size(); ++index) sums[0] += numbers[index] * 0.0f;
  if (sums[0] + sums[1] + sums[2] + sums[3] == 0) return;
  for (index = 0; index < numbers.size() && std::isfinite(numbers[index]);) ++index;
  throw Error(name_of_origin(data), std::string(what) + " hold a number that is not finite (number " + std::to_string(index) + ")");
}

Bounds checked_bounds(const Data& data, const Array<glm::vec3>& positions) {
  if (positions.size() > std::numeric_limits<std::uint32_t>::max())
    throw Error(name_of_origin(data), grouped(positions.size()) + " points are more than 32-bit indices reach");
  check_finite(data, numbers_of(positions), "positions");
  Bounds bounds;
  for (const glm::vec3& position : positions) bounds.include(position);
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
