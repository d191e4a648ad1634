/// What all data shares: boxes, names, number formatting.
#include <lumen/data.h>

#include <glm/vec4.hpp>

namespace lumen {

Data::~Data() = default;

std::string_view name_of(DataKind kind) {
  switch (kind) {
    case DataKind::mesh: return "mesh";
    case DataKind::lines: return "lines";
    case DataKind::volume: return "volume";
    case DataKind::image: return "image";
  }
  return "";
}

void Bounds::include(glm::vec3 point) {
  min = glm::min(min, point);
  max = glm::max(max, point);
}

void Bounds::include(const Bounds& other) {
  min = glm::min(min, other.min);
  max = glm::max(max, other.max);
}

Bounds Bounds::transformed(const glm::mat4& matrix) const {
  Bounds result;
  if (empty()) return result;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec4 point(corner & 1 ? max.x : min.x, corner & 2 ? max.y : min.y, corner & 4 ? max.z : min.z, 1);
    const glm::vec4 moved = matrix * point;
    result.include(glm::vec3(moved) / moved.w);
  }
  return result;
}

std::string grouped(std::size_t number) {
  std::string text = std::to_string(number);
  for (auto position = static_cast<std::ptrdiff_t>(text.size()) - 3; position > 0; position -= 3)
    text.insert(static_cast<std::size_t>(position), 1, ',');
  return text;
}

}  // namespace lumen
