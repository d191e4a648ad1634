#include "frame/property_rows.h"

#include <algorithm>
#include <cstdio>

#include "frame/hash.h"

namespace lumenshop {
namespace {

using lumen::ValueType;

int choice_index(const lumen::PropertySpec& spec, const lumen::Choice& choice) {
  const auto& names = spec.options.choices;
  return int(std::find(names.begin(), names.end(), choice.name) - names.begin());
}

struct Reading {
  const char* type;
  const char* swizzle;  // printf format of the expression that reads vec4 %s
};

Reading glsl_of(ValueType type) {
  switch (type) {
    case ValueType::boolean: return {"bool", "%s.x > 0.5"};
    case ValueType::integer: case ValueType::choice: return {"int", "int(%s.x)"};
    case ValueType::real: return {"float", "%s.x"};
    case ValueType::vec2: return {"vec2", "%s.xy"};
    case ValueType::vec3: case ValueType::color: return {"vec3", "%s.xyz"};
    case ValueType::vec4: case ValueType::rotation: return {"vec4", "%s"};
    case ValueType::transfer_function: return {"TransferFunction", "TransferFunction(%s.x, %s.yz)"};
    case ValueType::data: return {"Image", "Image(%s)"};
    default: return {"mat4", "%s"};
  }
}

std::string literal(const glm::vec4& v) {
  char text[160];
  std::snprintf(text, sizeof text, "vec4(%.9g, %.9g, %.9g, %.9g)", double(v.x), double(v.y), double(v.z), double(v.w));
  return text;
}

std::string substitute(std::string format, const std::string& value) {
  for (std::size_t at; (at = format.find("%s")) != std::string::npos;) format.replace(at, 2, value);
  return format;
}

}  // namespace

int row_count(const lumen::PropertySpec& spec) {
  switch (spec.type) {
    case ValueType::mat4: return 4;
    case ValueType::data: return spec.data_kind == lumen::DataKind::image && !spec.output ? 1 : 0;
    case ValueType::string: case ValueType::path: case ValueType::integers: case ValueType::reals: case ValueType::strings:
    case ValueType::reference: case ValueType::references: return 0;
    default: return 1;
  }
}

void append_rows(const lumen::PropertySpec& spec, const lumen::Value& value, std::vector<glm::vec4>& rows) {
  switch (spec.type) {
    case ValueType::boolean: rows.emplace_back(std::get<bool>(value) ? 1.0f : 0.0f, 0, 0, 0); break;
    case ValueType::integer: rows.emplace_back(float(std::get<int>(value)), 0, 0, 0); break;
    case ValueType::real: rows.emplace_back(std::get<float>(value), 0, 0, 0); break;
    case ValueType::vec2: rows.emplace_back(std::get<glm::vec2>(value), 0, 0); break;
    case ValueType::vec3: rows.emplace_back(std::get<glm::vec3>(value), 0); break;
    case ValueType::vec4: rows.push_back(std::get<glm::vec4>(value)); break;
    case ValueType::color: rows.emplace_back(std::get<lumen::Color>(value).rgb, 1); break;
    case ValueType::rotation: {
      const glm::quat& q = std::get<glm::quat>(value);
      rows.emplace_back(q.x, q.y, q.z, q.w);
      break;
    }
    case ValueType::mat4:
      for (int column = 0; column < 4; ++column) rows.push_back(std::get<glm::mat4>(value)[column]);
      break;
    case ValueType::choice: rows.emplace_back(float(choice_index(spec, std::get<lumen::Choice>(value))), 0, 0, 0); break;
    default: break;
  }
}

std::uint64_t properties_signature(const Instance& instance) {
  Hash hash;
  const auto& slots = instance.slots();
  for (int i = 0; i < int(slots.size()); ++i) {
    const Slot& slot = *slots[std::size_t(i)];
    if (slot.retracted || row_count(slot.spec) == 0) continue;
    hash.add(slot.spec.id).add(slot.spec.type);
    if (!slot.spec.options.constant) continue;
    std::vector<glm::vec4> constant;
    append_rows(slot.spec, instance.read(i), constant);
    for (const glm::vec4& row : constant) hash.add(row);
  }
  return hash.value();
}

std::string properties_text(const Instance& instance, const std::string& prefix, int binding) {
  std::string fields, loads;
  int offset = 0;
  const auto& slots = instance.slots();
  for (int i = 0; i < int(slots.size()); ++i) {
    const Slot& slot = *slots[std::size_t(i)];
    const int count = slot.retracted ? 0 : row_count(slot.spec);
    if (count == 0) continue;
    const Reading reading = glsl_of(slot.spec.type);
    fields += std::string("  ") + reading.type + " " + slot.spec.id + ";\n";
    std::string value;
    std::vector<glm::vec4> constant;
    if (slot.spec.options.constant) append_rows(slot.spec, instance.read(i), constant);
    for (int row = 0; row < count; ++row) {
      const std::string place = std::to_string(offset + row);
      const std::string vector = !constant.empty()                        ? literal(constant[std::size_t(row)])
                                 : binding == row_binding::any ? "lumen_values[row + " + place + "]"
                                                               : prefix + "row[" + place + "]";
      value += (row ? ", " : "") + substitute(reading.swizzle, vector);
    }
    if (count == 4) value = "mat4(" + value + ")";
    loads += "  p." + slot.spec.id + " = " + value + ";\n";
    offset += count;
  }
  const std::string type = prefix + "Properties";
  const std::string block = binding == row_binding::any ? std::string()
                                                        : "layout(std140, binding = " + std::to_string(binding) + ") uniform " + prefix + "Row { vec4 " + prefix +
                                                              "row[" + std::to_string(std::max(offset, 1)) + "]; };\n";
  return block + "struct " + type + " {\n" + fields + "};\n" + type + " " + prefix + "load(int row) {\n  " + type + " p;\n" + loads + "  return p;\n}\n";
}

}  // namespace lumenshop
