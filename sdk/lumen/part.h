/// Parts of a surface: what a splitter makes of it.
#pragma once

#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

namespace lumen {

/// A copy of the surface: cut in untouched world space, then moved.
struct Part {
  glm::mat4 transform{1};          ///< world to world, after the cut
  std::vector<glm::vec4> planes;   ///< world; keeps dot(n, v) + d >= 0; at most 8
  bool operator==(const Part&) const = default;
};

}  // namespace lumen
