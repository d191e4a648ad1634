/// A scalar or vector field on a regular grid.
#pragma once

#include <variant>

#include <lumen/data.h>

namespace lumen {

/// x runs fastest. `to_object` maps index space (voxel centers at whole numbers) to object space, so it holds
/// spacing, origin and direction, oblique and sheared ones included.
struct Volume : Data {
  glm::ivec3 dimensions{0};
  int components = 1;
  std::variant<Array<std::uint8_t>, Array<std::int16_t>, Array<std::uint16_t>, Array<float>> voxels;
  glm::vec2 value_range{0, 1};   ///< smallest and largest stored value of component 0
  glm::vec2 scale_offset{1, 0};  ///< physical value = stored * x + y
  glm::mat4 to_object{1};

  DataKind kind() const override { return DataKind::volume; }
  std::size_t bytes() const override;
  Bounds bounds() const override;  ///< of the cell-centered box: half a voxel beyond the outer centers is not included
  std::string summary() const override;

  /// Checks sizes and an invertible matrix, and computes value_range. Throws Error naming `origin`.
  void finish();
};

}  // namespace lumen
