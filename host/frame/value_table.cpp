#include "frame/value_table.h"

#include <algorithm>
#include <cstdio>
#include <span>

#include <glm/gtc/type_ptr.hpp>

#include "frame/hash.h"

namespace lumenshop {
namespace {

using lumen::ValueType;

constexpr int transfer_texels = 1024;

/// Rows begin where a uniform block may: 256 bytes is the largest alignment that GL allows a driver to ask for.
constexpr std::size_t row_alignment = 256 / sizeof(glm::vec4);

int rows_for(ValueType type) {
  switch (type) {
    case ValueType::mat4: return 4;
    case ValueType::string: case ValueType::path: case ValueType::integers: case ValueType::reals: case ValueType::strings:
    case ValueType::reference: case ValueType::references: case ValueType::data: return 0;
    default: return 1;
  }
}

int choice_index(const lumen::PropertySpec& spec, const lumen::Choice& choice) {
  const auto& names = spec.options.choices;
  return int(std::find(names.begin(), names.end(), choice.name) - names.begin());
}

/// The numbers of a value, 4 or 16; a transfer function's row is filled in by the table.
void append(const lumen::PropertySpec& spec, const lumen::Value& value, std::vector<glm::vec4>& out) {
  switch (spec.type) {
    case ValueType::boolean: out.emplace_back(std::get<bool>(value) ? 1.0f : 0.0f, 0, 0, 0); break;
    case ValueType::integer: out.emplace_back(float(std::get<int>(value)), 0, 0, 0); break;
    case ValueType::real: out.emplace_back(std::get<float>(value), 0, 0, 0); break;
    case ValueType::vec2: out.emplace_back(std::get<glm::vec2>(value), 0, 0); break;
    case ValueType::vec3: out.emplace_back(std::get<glm::vec3>(value), 0); break;
    case ValueType::vec4: out.push_back(std::get<glm::vec4>(value)); break;
    case ValueType::color: out.emplace_back(std::get<lumen::Color>(value).rgb, 1); break;
    case ValueType::rotation: {
      const glm::quat& q = std::get<glm::quat>(value);
      out.emplace_back(q.x, q.y, q.z, q.w);
      break;
    }
    case ValueType::mat4:
      for (int column = 0; column < 4; ++column) out.push_back(std::get<glm::mat4>(value)[column]);
      break;
    case ValueType::choice: out.emplace_back(float(choice_index(spec, std::get<lumen::Choice>(value))), 0, 0, 0); break;
    default: break;
  }
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

void ValueTable::update(const Session& session) {
  if (revision_ == session.revision()) return;
  revision_ = session.revision();
  rows_.clear();
  std::vector<glm::vec4> rows;
  std::vector<lumen::TransferFunction> functions;
  for (const auto& instance : session.plugins()) {
    rows_[instance.get()] = int(rows.size());
    const auto& slots = instance->slots();
    for (int i = 0; i < int(slots.size()); ++i) {
      const Slot& slot = *slots[std::size_t(i)];
      if (slot.retracted) continue;
      const lumen::Value& value = instance->read(i);
      if (slot.spec.type == ValueType::transfer_function) {
        const auto& function = std::get<lumen::TransferFunction>(value);
        auto found = std::find(functions.begin(), functions.end(), function);
        if (found == functions.end()) found = functions.insert(functions.end(), function);
        rows.emplace_back(float(found - functions.begin()), function.range.x, function.range.y, 0);
      } else {
        append(slot.spec, value, rows);
      }
    }
    rows.resize((rows.size() + row_alignment - 1) / row_alignment * row_alignment);
  }
  if (rows.empty()) rows.resize(row_alignment);
  values_.write(std::as_bytes(std::span(rows)));
  if (functions != uploaded_ || !transfer_functions_) {
    std::vector<float> texels(std::max<std::size_t>(functions.size(), 1) * transfer_texels * 4, 1.0f);
    for (std::size_t f = 0; f < functions.size(); ++f) {
      const glm::vec2 range = functions[f].range;
      for (int i = 0; i < transfer_texels; ++i) {
        const glm::vec4 color = functions[f].at(glm::mix(range.x, range.y, float(i) / (transfer_texels - 1)));
        std::copy_n(glm::value_ptr(color), 4, &texels[(f * transfer_texels + std::size_t(i)) * 4]);
      }
    }
    const glm::ivec2 size(transfer_texels, int(texels.size() / (transfer_texels * 4)));
    if (!transfer_functions_ || transfer_functions_.size() != size) transfer_functions_ = lumen::gl::Texture(lumen::Format::RGBA32F, size);
    transfer_functions_.upload(texels.data());
    uploaded_ = std::move(functions);
  }
}

int ValueTable::row_of(const Instance& instance) const {
  const auto found = rows_.find(&instance);
  return found == rows_.end() ? 0 : found->second;
}

void ValueTable::bind(Program& program) const {
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, values_.name());
  program.bind("lumen_transfer_functions", transfer_functions_.name());
}

void ValueTable::bind_row(int binding, const Instance& instance) const {
  const auto at = rows_.find(&instance);
  const std::size_t first = at == rows_.end() ? 0 : std::size_t(at->second) * sizeof(glm::vec4);
  // To the end of the buffer or as far as a block may reach: what the program declares is within.
  const std::size_t size = std::min(values_.size() - first, std::size_t(16384));
  glBindBufferRange(GL_UNIFORM_BUFFER, GLuint(binding), values_.name(), GLintptr(first), GLsizeiptr(size));
}

std::uint64_t properties_signature(const Instance& instance) {
  Hash hash;
  const auto& slots = instance.slots();
  for (int i = 0; i < int(slots.size()); ++i) {
    const Slot& slot = *slots[std::size_t(i)];
    if (slot.retracted || rows_for(slot.spec.type) == 0) continue;
    hash.add(slot.spec.id).add(slot.spec.type);
    if (!slot.spec.options.constant) continue;
    std::vector<glm::vec4> constant;
    append(slot.spec, instance.read(i), constant);
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
    const int count = slot.retracted ? 0 : rows_for(slot.spec.type);
    if (count == 0) continue;
    const Reading reading = glsl_of(slot.spec.type);
    fields += std::string("  ") + reading.type + " " + slot.spec.id + ";\n";
    std::string value;
    std::vector<glm::vec4> constant;
    if (slot.spec.options.constant) append(slot.spec, instance.read(i), constant);
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
