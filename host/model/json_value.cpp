#include "model/json_value.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <nlohmann/json.hpp>

#include <lumen/error.h>

#include "model/components.h"
#include "model/nearest_name.h"

namespace lumenshop {

using lumen::Value;
using lumen::ValueType;

namespace {

constexpr std::size_t most_entries = 65536;

/// The shortest number that reads back as the same float: 0.1, not 0.10000000149; whole ones without a fraction.
Json number_json(float number) {
  if (number == std::floor(number) && std::abs(number) < 1e7f && !(number == 0 && std::signbit(number))) return static_cast<int>(number);
  char text[48];
  const auto [end, ok] = std::to_chars(text, text + sizeof text, number);
  double wide = number;
  std::from_chars(text, end, wide);
  return wide;
}

template <class List>
Json list_json(const List& list) {
  Json result = Json::array();
  for (const auto& entry : list) {
    if constexpr (std::is_same_v<typename List::value_type, float>) result.push_back(number_json(entry));
    else result.push_back(entry);
  }
  return result;
}

std::string expected(ValueType type) {
  switch (type) {
    case ValueType::boolean: return "true or false";
    case ValueType::integer: return "a whole number";
    case ValueType::real: return "a number";
    case ValueType::vec2: return "an array of 2 numbers";
    case ValueType::vec3: return "an array of 3 numbers";
    case ValueType::vec4: return "an array of 4 numbers";
    case ValueType::color: return "an array of 3 numbers, linear red, green and blue";
    case ValueType::rotation: return "an array of 4 numbers, a quaternion x, y, z, w";
    case ValueType::mat4: return "an array of 16 numbers, row by row";
    case ValueType::string: return "a string";
    case ValueType::path: return "a string, a file's path";
    case ValueType::choice: return "a string";
    case ValueType::transfer_function: return "an object {\"range\": [a, b], \"points\": [[x, r, g, b, a], ...]} with a < b and two points or more";
    case ValueType::integers: return "an array of whole numbers";
    case ValueType::reals: return "an array of numbers";
    case ValueType::strings: return "an array of strings";
    case ValueType::reference: return "a string, an instance's id";
    case ValueType::references: return "an array of strings, instances' ids";
    case ValueType::data: return "a link to data, {\"link\": \"instance.property\"}";
  }
  return {};
}

std::string excerpt(const Json& json) {
  if (json.is_object() && json.size() > 8) return "an object";
  if (json.is_array() && json.size() > 16) return "an array of " + std::to_string(json.size()) + " entries";
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (text.size() > 80) text = text.substr(0, 77) + "...";
  return text;
}

[[noreturn]] void refuse(const Json& json, const lumen::PropertySpec& spec) {
  throw lumen::Error(spec.id, "expected " + expected(spec.type) + ", not " + excerpt(json));
}

double number_of(const Json& json, const lumen::PropertySpec& spec) {
  if (!json.is_number()) refuse(json, spec);
  const double number = json.get<double>();
  if (!std::isfinite(number)) throw lumen::Error(spec.id, "the number is not finite");
  return number;
}

double whole_number_of(const Json& json, const lumen::PropertySpec& spec) {
  const double number = number_of(json, spec);
  if (number != std::floor(number)) refuse(json, spec);
  return number;
}

const std::string& string_of(const Json& json, const lumen::PropertySpec& spec) {
  if (!json.is_string()) refuse(json, spec);
  return json.get_ref<const std::string&>();
}

const Json& array_of(const Json& json, const lumen::PropertySpec& spec) {
  if (!json.is_array()) refuse(json, spec);
  if (json.size() > most_entries)
    throw lumen::Error(spec.id, "a list of " + std::to_string(json.size()) + " entries; at most " + std::to_string(most_entries) + " are taken");
  return json;
}

std::vector<std::string> strings_of(const Json& json, const lumen::PropertySpec& spec) {
  std::vector<std::string> result;
  result.reserve(array_of(json, spec).size());
  for (const Json& entry : json) {
    if (!entry.is_string()) refuse(json, spec);
    result.push_back(entry.get<std::string>());
  }
  return result;
}

lumen::Choice choice_of(const Json& json, const lumen::PropertySpec& spec) {
  const std::string& name = string_of(json, spec);
  const auto& names = spec.options.choices;
  if (std::find(names.begin(), names.end(), name) != names.end()) return {name};
  std::string known;
  for (const std::string& choice : names) known += (known.empty() ? "" : ", ") + choice;
  throw lumen::Error(spec.id, "'" + name.substr(0, 80) + "' is not one of " + known, suggestion(name, names));
}

lumen::TransferFunction transfer_function_of(const Json& json, const lumen::PropertySpec& spec) {
  const auto range = json.is_object() ? json.find("range") : json.end();
  const auto points = json.is_object() ? json.find("points") : json.end();
  // Keys that we do not know would be lost at the next save: refused, the whole is kept as it is.
  if (range == json.end() || points == json.end() || json.size() != 2 || !range->is_array() || range->size() != 2) refuse(json, spec);
  lumen::TransferFunction result;
  const auto narrow = [&](const Json& number) { return std::get<float>(from_components(ValueType::real, std::array{number_of(number, spec)})); };
  result.range = {narrow((*range)[0]), narrow((*range)[1])};
  if (!(result.range.x < result.range.y) || array_of(*points, spec).size() < 2) refuse(json, spec);
  result.points.reserve(points->size());
  for (const Json& point : *points) {
    if (!point.is_array() || point.size() != 5) refuse(json, spec);
    result.points.push_back({narrow(point[0]), {narrow(point[1]), narrow(point[2]), narrow(point[3]), narrow(point[4])}});
  }
  return result;
}

Value vector_of(const Json& json, const lumen::PropertySpec& spec) {
  const int count = components_in(spec.type);
  if (!json.is_array() || json.size() != static_cast<std::size_t>(count)) refuse(json, spec);
  std::array<double, 16> numbers{};
  double sum = 0;
  for (int i = 0; i < count; ++i) {
    numbers[i] = number_of(json[i], spec);
    sum += std::abs(numbers[i]);
  }
  if (spec.type == ValueType::rotation && sum == 0) throw lumen::Error(spec.id, "[0, 0, 0, 0] is no rotation", "no turn is [0, 0, 0, 1]");
  return from_components(spec.type, numbers);
}

}  // namespace

Json to_json(const Value& value) {
  switch (lumen::type_of(value)) {
    case ValueType::boolean: return std::get<bool>(value);
    case ValueType::integer: return std::get<int>(value);
    case ValueType::real: return number_json(std::get<float>(value));
    case ValueType::string: return std::get<std::string>(value);
    case ValueType::path: return std::get<lumen::Path>(value).file;
    case ValueType::choice: return std::get<lumen::Choice>(value).name;
    case ValueType::transfer_function: {
      const auto& function = std::get<lumen::TransferFunction>(value);
      Json points = Json::array();
      for (const auto& point : function.points)
        points.push_back(list_json(std::vector<float>{point.x, point.rgba.x, point.rgba.y, point.rgba.z, point.rgba.w}));
      Json result = Json::object();
      result["range"] = list_json(std::vector<float>{function.range.x, function.range.y});
      result["points"] = std::move(points);
      return result;
    }
    case ValueType::integers: return list_json(std::get<std::vector<int>>(value));
    case ValueType::reals: return list_json(std::get<std::vector<float>>(value));
    case ValueType::strings: return list_json(std::get<std::vector<std::string>>(value));
    case ValueType::reference: return std::get<lumen::Reference>(value).id;
    case ValueType::references: return list_json(std::get<lumen::References>(value).ids);
    case ValueType::data: return nullptr;
    default: {
      const Components components = components_of(value);
      Json result = Json::array();
      for (const double number : components.view()) result.push_back(number_json(static_cast<float>(number)));
      return result;
    }
  }
}

Value from_json(const Json& json, const lumen::PropertySpec& spec) {
  switch (spec.type) {
    case ValueType::boolean:
      if (!json.is_boolean()) refuse(json, spec);
      return json.get<bool>();
    case ValueType::integer: return clamped(from_components(spec.type, std::array{whole_number_of(json, spec)}), spec);
    case ValueType::real: return clamped(from_components(spec.type, std::array{number_of(json, spec)}), spec);
    case ValueType::string: return string_of(json, spec);
    case ValueType::path: return lumen::Path{string_of(json, spec)};
    case ValueType::choice: return choice_of(json, spec);
    case ValueType::transfer_function: return clamped(transfer_function_of(json, spec), spec);
    case ValueType::integers: {
      std::vector<int> list;
      list.reserve(array_of(json, spec).size());
      for (const Json& entry : json) list.push_back(std::get<int>(from_components(ValueType::integer, std::array{whole_number_of(entry, spec)})));
      return clamped(std::move(list), spec);
    }
    case ValueType::reals: {
      std::vector<float> list;
      list.reserve(array_of(json, spec).size());
      for (const Json& entry : json) list.push_back(std::get<float>(from_components(ValueType::real, std::array{number_of(entry, spec)})));
      return clamped(std::move(list), spec);
    }
    case ValueType::strings: return strings_of(json, spec);
    case ValueType::reference:
      if (json.is_null()) return lumen::Reference{};
      return lumen::Reference{string_of(json, spec)};
    case ValueType::references:
      if (json.is_string()) return json.get_ref<const std::string&>().empty() ? lumen::References{} : lumen::References{{json.get<std::string>()}};
      return lumen::References{strings_of(json, spec)};
    case ValueType::data: refuse(json, spec);
    default: return clamped(vector_of(json, spec), spec);
  }
}

}  // namespace lumenshop
