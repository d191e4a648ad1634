/// Parts of a surface: what splitters make of it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

namespace lumen {

struct Mesh;

/// A copy of the surface: cut in untouched world space, then moved.
struct Part {
  glm::mat4 transform{1};          ///< world to world, after the cut
  std::vector<glm::vec4> planes = {};  ///< world, normals unit; keeps dot(n, v) + d >= 0; at most 8
  int group = -1;                  ///< the triangles of this group (Split::groups); -1: all
  bool removable = true;           ///< the splitters' removed() is asked
  /// Spheres (center, radius; world, before the move) that together hold every hole that the planes cut into a closed surface:
  /// through these alone one sees its inside. None given: anywhere. An empty list: caps close it.
  std::optional<std::vector<glm::vec4>> openings = {};
  bool operator==(const Part&) const = default;
};

/// What closes a part where a plane cut it.
struct Cap {
  int part = 0;                    ///< index of the part
  int plane = 0;                   ///< index of its plane; the cap faces against the plane's normal
  std::shared_ptr<const Mesh> shape;  ///< triangles in the plane, world, before the move, for the whole plane: other planes cut it
  bool operator==(const Cap&) const = default;
};

/// A surface in parts.
struct Split {
  std::vector<Part> parts = {Part{}};
  /// The group of each triangle of the mesh, where parts have groups. Another grouping is another object.
  std::shared_ptr<const std::vector<std::uint32_t>> groups = {};
  std::vector<Cap> caps = {};
  bool operator==(const Split&) const = default;
};

}  // namespace lumen
