#include "frame/value_table.h"

#include <algorithm>
#include <span>

#include <glm/gtc/type_ptr.hpp>

namespace lumenshop {
namespace {

using lumen::Kind;
using lumen::ValueType;

constexpr int transfer_texels = 1024;

/// Rows begin where a uniform block may: 256 bytes is the largest alignment that GL allows a driver to ask for.
constexpr std::size_t row_alignment = 256 / sizeof(glm::vec4);

bool has_shader(const Instance& instance) {
  const Kind kind = instance.kind();
  return kind != Kind::importer && kind != Kind::exporter && kind != Kind::filter && kind != Kind::editor;
}

/// The picture that a property holds for a shader, or null.
std::shared_ptr<const lumen::Image> picture_of(const Instance& instance, const Slot& slot, const lumen::Value& value) {
  if (slot.spec.type != ValueType::data || row_count(slot.spec) == 0 || !has_shader(instance)) return nullptr;
  return std::dynamic_pointer_cast<const lumen::Image>(std::get<lumen::DataPointer>(value));
}

template <class Visit>
void for_each_value(const Session& session, Visit visit) {
  for (const auto& instance : session.plugins()) {
    const auto& slots = instance->slots();
    for (int i = 0; i < int(slots.size()); ++i)
      if (const Slot& slot = *slots[std::size_t(i)]; !slot.retracted) visit(*instance, slot, instance->read(i));
  }
}

}  // namespace

void ValueTable::update(const Session& session) {
  if (revision_ == session.revision()) return;
  revision_ = session.revision();
  update_pictures(session);
  rows_.clear();
  std::vector<glm::vec4> rows;
  std::vector<lumen::TransferFunction> functions;
  const auto align = [&] { rows.resize((rows.size() + row_alignment - 1) / row_alignment * row_alignment); };
  const Instance* current = nullptr;
  for_each_value(session, [&](const Instance& instance, const Slot& slot, const lumen::Value& value) {
    if (&instance != current) {
      align();
      current = &instance;
      rows_[current] = int(rows.size());
    }
    if (slot.spec.type == ValueType::transfer_function) {
      const auto& function = std::get<lumen::TransferFunction>(value);
      auto found = std::find(functions.begin(), functions.end(), function);
      if (found == functions.end()) found = functions.insert(functions.end(), function);
      rows.emplace_back(float(found - functions.begin()), function.range.x, function.range.y, 0);
    } else if (slot.spec.type == ValueType::data) {
      const auto picture = picture_of(instance, slot, value);
      if (row_count(slot.spec) > 0) rows.push_back(picture == nullptr ? glm::vec4(0) : pictures_.place_of(*picture));
    } else {
      append_rows(slot.spec, value, rows);
    }
  });
  align();
  if (rows.empty()) rows.resize(row_alignment);
  values_.write(std::as_bytes(std::span(rows)));
  if (functions != uploaded_ || !transfer_functions_) upload(std::move(functions));
}

void ValueTable::update_pictures(const Session& session) {
  std::vector<std::shared_ptr<const lumen::Image>> pictures;
  for_each_value(session, [&](const Instance& instance, const Slot& slot, const lumen::Value& value) {
    auto picture = picture_of(instance, slot, value);
    if (picture != nullptr && std::find(pictures.begin(), pictures.end(), picture) == pictures.end()) pictures.push_back(std::move(picture));
  });
  pictures_.update(std::move(pictures));
}

void ValueTable::upload(std::vector<lumen::TransferFunction> functions) {
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

int ValueTable::row_of(const Instance& instance) const {
  const auto found = rows_.find(&instance);
  return found == rows_.end() ? 0 : found->second;
}

void ValueTable::bind(Program& program) const {
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, values_.name());
  program.bind("lumen_transfer_functions", transfer_functions_.name());
  program.bind("lumen_images", pictures_.texture().name());
}

void ValueTable::bind_row(int binding, const Instance& instance) const {
  const auto at = rows_.find(&instance);
  const std::size_t first = at == rows_.end() ? 0 : std::size_t(at->second) * sizeof(glm::vec4);
  // To the end of the buffer or as far as a block may reach: what the program declares is within.
  const std::size_t size = std::min(values_.size() - first, std::size_t(16384));
  glBindBufferRange(GL_UNIFORM_BUFFER, GLuint(binding), values_.name(), GLintptr(first), GLsizeiptr(size));
}

std::vector<lumen::Problem> ValueTable::problems() const {
  std::vector<lumen::Problem> all;
  for (const std::string& message : pictures_.refused()) all.push_back({.severity = lumen::Severity::error, .message = message});
  return all;
}

}  // namespace lumenshop
