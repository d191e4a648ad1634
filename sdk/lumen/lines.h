/// Polylines.
#pragma once

#include <lumen/data.h>

namespace lumen {

/// Polylines, one after the other in `positions`.
struct Lines : Data {
  Array<glm::vec3> positions;         ///< object space; finite
  Array<std::uint32_t> offsets;       ///< first position of each line, plus the total: lines + 1 entries
  std::vector<Attribute> attributes;  ///< point tuples: one per position; cell tuples: one per line

  DataKind kind() const override { return DataKind::lines; }
  std::size_t bytes() const override;
  Bounds bounds() const override;
  std::string summary() const override;
  std::size_t count() const { return offsets.empty() ? 0 : offsets.size() - 1; }
  std::span<const glm::vec3> line(std::size_t index) const;

  /// Checks sizes, offsets and finite positions, and computes the bounds. Throws Error naming `origin`.
  void finish();

 private:
  Bounds bounds_;
};

}  // namespace lumen
