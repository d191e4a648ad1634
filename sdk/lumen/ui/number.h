/// Numbers in fields: how they are written, read and dragged. Pure functions.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <lumen/property.h>

namespace lumen::ui {

/// The range that a number moves in.
struct NumberRange {
  double min = -1e30, max = 1e30;  ///< at +-1e30 and beyond: open
  double step = 0;                 ///< 0 = from the range
  bool logarithmic = false;        ///< takes effect with min > 0 alone
  bool integer = false;

  static NumberRange of(const PropertySpec& spec);
  bool bounded() const { return min > -1e30 && max < 1e30 && max > min; }
  double step_size() const;        ///< > 0: `step`, else 1 for integers, else a round hundredth of the range
};

/// Four significant digits; integers whole.
std::string written(double value, bool integer);
/// All digits that tell a float from its neighbors.
std::string written_fully(double value, bool integer);

/// What a person typed: a number or arithmetic with + - * / ^ ( ) and pi. Nothing if it is not that, or not finite.
std::optional<double> calculated(std::string_view text);

/// The value after dragging `pixels` (UI units, right positive) from `start`: the range in 300, in log space if
/// logarithmic; an open range moves by the size of the value. `snap` rounds to the step. Clamped.
double dragged(const NumberRange& range, double start, double pixels, bool snap);

/// The value `steps` steps on. Clamped.
double stepped(const NumberRange& range, double value, double steps);

/// Where the value stands in its range, 0..1; nothing for open ranges.
std::optional<double> place_of(const NumberRange& range, double value);

}  // namespace lumen::ui
