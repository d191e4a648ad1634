/// Volumes: checks, bounds, value range.
#include <lumen/volume.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include <glm/matrix.hpp>

#include <checks/data_check.h>
#include <lumen/error.h>

namespace lumen {

namespace {

const char* const type_names[] = {"uint8", "int16", "uint16", "float"};

/// Smallest and largest finite value of component 0; {0, 0} if there is none.
template <class T> glm::vec2 range_of(const Array<T>& voxels, std::size_t components) {
  T low = std::numeric_limits<T>::max(), high = std::numeric_limits<T>::lowest();
  for (std::size_t index = 0; index < voxels.size(); index += components) {
    const T value = voxels[index];
    if constexpr (std::is_floating_point_v<T>)
      if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  return low <= high ? glm::vec2(low, high) : glm::vec2(0);
}

}  // namespace

std::size_t Volume::bytes() const {
  return std::visit([](const auto& array) { return array.view().size_bytes(); }, voxels);
}

Bounds Volume::bounds() const {
  Bounds box;
  box.min = glm::vec3(0);
  box.max = glm::vec3(dimensions - 1);
  return box.transformed(to_object);
}

std::string Volume::summary() const {
  return std::to_string(dimensions.x) + " x " + std::to_string(dimensions.y) + " x " + std::to_string(dimensions.z) + " " +
         type_names[voxels.index()] + (components > 1 ? ", " + std::to_string(components) + " components" : "");
}

void Volume::finish() {
  const auto fail = [&](const std::string& what) { throw Error(detail::name_of_origin(*this), what); };
  constexpr int largest_side = 1 << 20;
  for (int axis = 0; axis < 3; ++axis)
    if (dimensions[axis] < 1 || dimensions[axis] > largest_side)
      fail("a volume of " + std::to_string(dimensions.x) + " x " + std::to_string(dimensions.y) + " x " + std::to_string(dimensions.z) +
           " voxels; each side must be 1 to 1,048,576");
  if (components < 1 || components > 16) fail(std::to_string(components) + " components per voxel; 1 to 16 are possible");
  const std::size_t wanted = std::size_t(dimensions.x) * std::size_t(dimensions.y) * std::size_t(dimensions.z);
  const std::size_t numbers = std::visit([](const auto& array) { return array.size(); }, voxels);
  if (numbers % std::size_t(components) != 0 || numbers / std::size_t(components) != wanted)
    fail(grouped(numbers) + " numbers for " + grouped(wanted) + " voxels of " + std::to_string(components) + " components");

  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      if (!std::isfinite(to_object[column][row])) fail("the matrix to object space is not finite");
  const float determinant = glm::determinant(glm::mat3(to_object));
  if (!std::isfinite(determinant) || determinant == 0) fail("the matrix to object space is not invertible");
  if (!std::isfinite(scale_offset.x) || !std::isfinite(scale_offset.y)) fail("scale and offset of the values are not finite");
  value_range = std::visit([&](const auto& array) { return range_of(array, std::size_t(components)); }, voxels);
}

}  // namespace lumen
