/// Numeric values seen as up to 16 numbers: what conversions, ranges, expressions and JSON arrays share.
#pragma once

#include <array>
#include <span>

#include <lumen/value.h>

namespace lumenshop {

/// bool, int, float 1; vectors and color their size; rotation x y z w; mat4 16, row by row; all else none.
struct Components {
  int count = 0;
  std::array<double, 16> values{};
  std::span<const double> view() const { return {values.data(), static_cast<std::size_t>(count)}; }
};

Components components_of(const lumen::Value& value);
int components_in(lumen::ValueType type);

/// The value of a numeric type; `numbers` has components_in(type) finite ones. Whole numbers are rounded, what a type
/// cannot hold becomes its nearest.
lumen::Value from_components(lumen::ValueType type, std::span<const double> numbers);

/// False if any number in it, of a list or transfer function too, is infinite or not a number.
bool is_finite(const lumen::Value& value);

}  // namespace lumenshop
