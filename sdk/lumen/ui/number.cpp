#include <lumen/ui/number.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace lumen::ui {
namespace {

constexpr double open_end = 1e30;
constexpr double pixels_per_range = 300;

double fitted(const NumberRange& range, double value) {
  if (range.integer) value = std::round(value);
  return std::clamp(value, range.min, std::max(range.min, range.max));
}

bool in_log_space(const NumberRange& range) { return range.logarithmic && range.min > 0; }

/// Recursive descent over + - * / ^ and parentheses; depth is bounded, for the text may come from the clipboard.
class Calculator {
 public:
  explicit Calculator(std::string_view text) : text_(text) {}

  std::optional<double> run() {
    const double value = sum();
    skip_blanks();
    if (failed_ || position_ != text_.size() || !std::isfinite(value)) return std::nullopt;
    return value;
  }

 private:
  void skip_blanks() { while (position_ < text_.size() && text_[position_] == ' ') ++position_; }
  bool take(char wanted) {
    skip_blanks();
    if (position_ >= text_.size() || text_[position_] != wanted) return false;
    ++position_;
    return true;
  }
  double sum() {
    if (++depth_ > 32) failed_ = true;
    double value = failed_ ? 0 : product();
    while (!failed_) {
      if (take('+')) value += product();
      else if (take('-')) value -= product();
      else break;
    }
    --depth_;
    return value;
  }
  double product() {
    double value = sign();
    while (!failed_) {
      if (take('*')) value *= sign();
      else if (take('/')) value /= sign();
      else break;
    }
    return value;
  }
  double sign() {
    bool negative = false;
    while (true) {
      if (take('-')) negative = !negative;
      else if (!take('+')) break;
    }
    const double value = power();
    return negative ? -value : value;
  }
  double power() {
    if (++depth_ > 32) { failed_ = true; return 0; }
    const double base = atom();
    const double value = !failed_ && take('^') ? std::pow(base, sign()) : base;
    --depth_;
    return value;
  }
  double atom() {
    if (take('(')) {
      const double value = sum();
      if (!take(')')) failed_ = true;
      return value;
    }
    skip_blanks();
    if (text_.substr(position_, 2) == "pi") {
      position_ += 2;
      return 3.14159265358979323846;
    }
    double value = 0;
    const auto [end, error] = std::from_chars(text_.data() + position_, text_.data() + text_.size(), value);
    if (error != std::errc{}) { failed_ = true; return 0; }
    position_ = static_cast<std::size_t>(end - text_.data());
    return value;
  }

  std::string_view text_;
  std::size_t position_ = 0;
  int depth_ = 0;
  bool failed_ = false;
};

}  // namespace

NumberRange NumberRange::of(const PropertySpec& spec) {
  return {std::max(spec.options.min, -open_end), std::min(spec.options.max, open_end), spec.options.step, spec.options.logarithmic,
          spec.type == ValueType::integer || spec.type == ValueType::integers};
}

double NumberRange::step_size() const {
  if (step > 0) return step;
  if (integer) return 1;
  if (!bounded()) return 0.1;
  return std::pow(10, std::floor(std::log10((max - min) / 100) + 1e-9));
}

std::string written(double value, bool integer) {
  std::array<char, 64> text{};
  const double size = std::abs(value);
  if (integer) {
    std::snprintf(text.data(), text.size(), "%.0f", value);
  } else if (!std::isfinite(value) || (size != 0 && (size < 1e-4 || size >= 1e7))) {
    std::snprintf(text.data(), text.size(), "%.3e", value);
  } else {
    const int whole_digits = size < 1 ? (size >= 0.1 || size == 0 ? 0 : static_cast<int>(std::floor(std::log10(size))) + 1)
                                      : static_cast<int>(std::floor(std::log10(size))) + 1;
    std::snprintf(text.data(), text.size(), "%.*f", std::clamp(size == 0 ? 3 : 4 - whole_digits, 0, 8), value);
  }
  return text.data();
}

std::string written_fully(double value, bool integer) {
  if (integer) return written(value, true);
  std::array<char, 64> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), static_cast<float>(value)).ptr;
  return {text.data(), end};
}

std::optional<double> calculated(std::string_view text) {
  if (text.size() > 256) return std::nullopt;
  return Calculator(text).run();
}

double dragged(const NumberRange& range, double start, double pixels, bool snap) {
  double value = start;
  if (in_log_space(range) && range.bounded()) {
    const double low = std::log(range.min), high = std::log(range.max);
    value = std::exp(std::log(std::max(start, range.min)) + (high - low) * pixels / pixels_per_range);
  } else if (in_log_space(range)) {
    value = std::max(start, range.min) * std::exp(pixels / 100);
  } else if (range.bounded()) {
    value = start + (range.max - range.min) * pixels / pixels_per_range;
  } else {
    value = start + std::max(std::abs(start), range.integer ? 25.0 : 1.0) * pixels / 100;
  }
  if (snap) value = std::round(value / range.step_size()) * range.step_size();
  return fitted(range, value);
}

double stepped(const NumberRange& range, double value, double steps) {
  if (in_log_space(range) && range.step <= 0 && !range.integer) return fitted(range, value * std::pow(1.1, steps));
  return fitted(range, value + steps * range.step_size());
}

std::optional<double> place_of(const NumberRange& range, double value) {
  if (!range.bounded()) return std::nullopt;
  const bool log = in_log_space(range);
  const auto along = [&](double x) { return log ? std::log(std::max(x, range.min)) : x; };
  return std::clamp((along(value) - along(range.min)) / (along(range.max) - along(range.min)), 0.0, 1.0);
}

}  // namespace lumen::ui
