// Numeric values as components, what links make of values, and ranges.
#include <algorithm>
#include <cmath>
#include <limits>

#include <lumen/error.h>

#include "model/components.h"
#include "model/json_value.h"

namespace lumenshop {

using lumen::Value;
using lumen::ValueType;

int components_in(ValueType type) {
  switch (type) {
    case ValueType::boolean: case ValueType::integer: case ValueType::real: return 1;
    case ValueType::vec2: return 2;
    case ValueType::vec3: case ValueType::color: return 3;
    case ValueType::vec4: case ValueType::rotation: return 4;
    case ValueType::mat4: return 16;
    default: return 0;
  }
}

Components components_of(const Value& value) {
  Components result;
  result.count = components_in(lumen::type_of(value));
  auto& out = result.values;
  switch (lumen::type_of(value)) {
    case ValueType::boolean: out[0] = std::get<bool>(value) ? 1 : 0; break;
    case ValueType::integer: out[0] = std::get<int>(value); break;
    case ValueType::real: out[0] = std::get<float>(value); break;
    case ValueType::vec2: for (int i = 0; i < 2; ++i) out[i] = std::get<glm::vec2>(value)[i]; break;
    case ValueType::vec3: for (int i = 0; i < 3; ++i) out[i] = std::get<glm::vec3>(value)[i]; break;
    case ValueType::vec4: for (int i = 0; i < 4; ++i) out[i] = std::get<glm::vec4>(value)[i]; break;
    case ValueType::color: for (int i = 0; i < 3; ++i) out[i] = std::get<lumen::Color>(value).rgb[i]; break;
    case ValueType::rotation: {
      const auto& q = std::get<glm::quat>(value);
      out[0] = q.x, out[1] = q.y, out[2] = q.z, out[3] = q.w;
      break;
    }
    case ValueType::mat4: for (int i = 0; i < 16; ++i) out[i] = std::get<glm::mat4>(value)[i % 4][i / 4]; break;
    default: break;
  }
  return result;
}

namespace {

float narrowed(double number) {
  constexpr double largest = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(number, -largest, largest));
}

int rounded(double number) {
  return static_cast<int>(std::clamp(std::round(number), double(std::numeric_limits<int>::min()), double(std::numeric_limits<int>::max())));
}

template <class Vector>
Vector vector_of(std::span<const double> numbers) {
  Vector result;
  for (int i = 0; i < Vector::length(); ++i) result[i] = narrowed(numbers[i]);
  return result;
}

bool is_scalar(ValueType type) { return components_in(type) == 1; }
bool is_vector(ValueType type) {
  return type == ValueType::vec2 || type == ValueType::vec3 || type == ValueType::vec4 || type == ValueType::color;
}

double in_range(double number, const lumen::PropertyOptions& options) { return std::max(options.min, std::min(options.max, number)); }

}  // namespace

Value from_components(ValueType type, std::span<const double> numbers) {
  switch (type) {
    case ValueType::boolean: return numbers[0] != 0;
    case ValueType::integer: return rounded(numbers[0]);
    case ValueType::real: return narrowed(numbers[0]);
    case ValueType::vec2: return vector_of<glm::vec2>(numbers);
    case ValueType::vec3: return vector_of<glm::vec3>(numbers);
    case ValueType::vec4: return vector_of<glm::vec4>(numbers);
    case ValueType::color: return lumen::Color(vector_of<glm::vec3>(numbers));
    case ValueType::rotation: return glm::quat(narrowed(numbers[3]), narrowed(numbers[0]), narrowed(numbers[1]), narrowed(numbers[2]));
    case ValueType::mat4: {
      glm::mat4 matrix;
      for (int i = 0; i < 16; ++i) matrix[i % 4][i / 4] = narrowed(numbers[i]);
      return matrix;
    }
    default: throw lumen::Error(std::string(lumen::name_of(type)) + " is not made of numbers");
  }
}

bool is_finite(const Value& value) {
  const auto finite = [](double number) { return std::isfinite(number); };
  if (const auto* list = std::get_if<std::vector<float>>(&value)) return std::all_of(list->begin(), list->end(), finite);
  if (const auto* function = std::get_if<lumen::TransferFunction>(&value)) {
    if (!finite(function->range.x) || !finite(function->range.y)) return false;
    return std::all_of(function->points.begin(), function->points.end(), [&](const auto& point) {
      return finite(point.x) && finite(point.rgba.x) && finite(point.rgba.y) && finite(point.rgba.z) && finite(point.rgba.w);
    });
  }
  const Components components = components_of(value);
  return std::all_of(components.view().begin(), components.view().end(), finite);
}

bool convertible(ValueType from, ValueType to) {
  if (from == to) return true;
  if (is_scalar(from) && is_scalar(to)) return from < to;  // bool -> int -> float
  if (is_scalar(from)) return is_vector(to);
  return (from == ValueType::vec3 && to == ValueType::color) || (from == ValueType::color && to == ValueType::vec3);
}

Value convert(const Value& value, const lumen::PropertySpec& target) {
  const ValueType from = lumen::type_of(value);
  if (!convertible(from, target.type))
    throw lumen::Error(std::string(lumen::name_of(from)) + " does not convert to " + std::string(lumen::name_of(target.type)));
  if (from == target.type) return clamped(value, target);
  Components components = components_of(value);
  if (is_vector(target.type) && components.count == 1) components.values.fill(components.values[0]);
  return clamped(from_components(target.type, components.values), target);
}

Value clamped(Value value, const lumen::PropertySpec& spec) {
  const lumen::PropertyOptions& options = spec.options;
  switch (lumen::type_of(value)) {
    case ValueType::integer: {
      const double number = std::max(std::ceil(options.min), std::min(std::floor(options.max), double(std::get<int>(value))));
      return rounded(number);
    }
    case ValueType::real: case ValueType::vec2: case ValueType::vec3: case ValueType::vec4: case ValueType::color: case ValueType::mat4: {
      Components components = components_of(value);
      for (double& number : components.values) number = in_range(number, options);
      return from_components(lumen::type_of(value), components.values);
    }
    case ValueType::rotation: {
      const auto& q = std::get<glm::quat>(value);
      const double length = std::sqrt(double(q.x) * q.x + double(q.y) * q.y + double(q.z) * q.z + double(q.w) * q.w);
      if (length < 1e-12) return glm::quat(1, 0, 0, 0);
      // An already unit one stays bit for bit, so that saving and loading it again changes nothing.
      if (std::abs(length - 1) < 1e-6) return value;
      return glm::quat(float(q.w / length), float(q.x / length), float(q.y / length), float(q.z / length));
    }
    case ValueType::choice: {
      const auto& names = options.choices;
      const bool known = names.empty() || std::find(names.begin(), names.end(), std::get<lumen::Choice>(value).name) != names.end();
      return known ? value : spec.default_value;
    }
    case ValueType::transfer_function: {
      auto& function = std::get<lumen::TransferFunction>(value);
      if (!(function.range.x < function.range.y)) function.range = {0, 1};
      std::stable_sort(function.points.begin(), function.points.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
      for (auto& point : function.points) point.rgba = glm::clamp(point.rgba, 0.0f, 1.0f);
      return value;
    }
    case ValueType::integers:
      for (int& number : std::get<std::vector<int>>(value))
        number = rounded(std::max(std::ceil(options.min), std::min(std::floor(options.max), double(number))));
      return value;
    case ValueType::reals:
      for (float& number : std::get<std::vector<float>>(value)) number = narrowed(in_range(number, options));
      return value;
    default: return value;
  }
}

}  // namespace lumenshop
