/// The checks that finish() of mesh and lines share. Private to the SDK's sources.
#pragma once

#include <string_view>

#include <lumen/data.h>

namespace lumen::detail {

/// `origin`, or what stands in for it in messages.
std::string name_of_origin(const Data& data);

/// The box of the points; throws Error if one is not finite or there are more than 32-bit indices reach.
Bounds checked_bounds(const Data& data, const Array<glm::vec3>& positions);

/// Throws Error unless all numbers are finite. `what`: "normals".
void check_finite(const Data& data, std::span<const float> numbers, std::string_view what);

/// Names not empty and unique per kind, 1..16 components, sizes: `points` tuples on points, `cells` tuples or more on cells.
/// With `exact_cells`, exactly `cells`.
void check_attributes(const Data& data, const std::vector<Attribute>& attributes, std::size_t points, std::size_t cells, bool exact_cells);

std::size_t bytes_of(const std::vector<Attribute>& attributes);

inline std::span<const float> numbers_of(const Array<glm::vec3>& array) {
  return {reinterpret_cast<const float*>(array.data()), array.size() * 3};
}
inline std::span<const float> numbers_of(const Array<glm::vec2>& array) {
  return {reinterpret_cast<const float*>(array.data()), array.size() * 2};
}

}  // namespace lumen::detail
