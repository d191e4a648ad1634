/// Names and sizes of the value types, and the evaluation of transfer functions.
#include <lumen/value.h>

#include <algorithm>

namespace lumen {

std::string_view name_of(ValueType type) {
  switch (type) {
    case ValueType::boolean: return "bool";
    case ValueType::integer: return "int";
    case ValueType::real: return "float";
    case ValueType::vec2: return "vec2";
    case ValueType::vec3: return "vec3";
    case ValueType::vec4: return "vec4";
    case ValueType::color: return "color";
    case ValueType::rotation: return "rotation";
    case ValueType::mat4: return "mat4";
    case ValueType::string: return "string";
    case ValueType::path: return "path";
    case ValueType::choice: return "choice";
    case ValueType::transfer_function: return "transfer function";
    case ValueType::integers: return "list of int";
    case ValueType::reals: return "list of float";
    case ValueType::strings: return "list of string";
    case ValueType::reference: return "reference";
    case ValueType::references: return "references";
    case ValueType::data: return "data";
  }
  return "";
}

int component_count(ValueType type) {
  switch (type) {
    case ValueType::boolean: case ValueType::integer: case ValueType::real: return 1;
    case ValueType::vec2: return 2;
    case ValueType::vec3: case ValueType::color: return 3;
    case ValueType::vec4: return 4;
    default: return 0;
  }
}

glm::vec4 TransferFunction::at(float x) const {
  if (points.empty()) return glm::vec4(1);
  const auto after = std::upper_bound(points.begin(), points.end(), x, [](float value, const Point& point) { return value < point.x; });
  if (after == points.begin()) return points.front().rgba;
  if (after == points.end()) return points.back().rgba;
  const Point& left = after[-1];
  const float width = after->x - left.x;
  return glm::mix(left.rgba, after->rgba, width > 0 ? (x - left.x) / width : 1.0f);
}

}  // namespace lumen
