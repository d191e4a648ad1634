/// A surface's parts as explosions see them: connected ones, or those of an array's values. Found once for a mesh.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <lumen/splitter.h>

/// The corners of a triangle.
using Corners = std::array<glm::vec3, 3>;

/// One part. World units.
struct Piece {
  int number = 0;                 ///< of the part, as picking and parts_of count
  std::vector<Corners> triangles;
  lumen::Bounds bounds;
  glm::vec3 center{0};            ///< of its area
  float area = 0, share = 0;      ///< world; of the area of all, 0..1
  bool torn = false;              ///< it hangs together with another: it is open where that leaves it
};

/// What is asked for; the same question has the same answer for as long as the mesh lives.
struct PiecesAsked {
  std::weak_ptr<const lumen::Mesh> mesh;
  glm::mat4 object_to_world{1};
  std::string group_by;           ///< name of an array; empty: the mesh's own parts
  bool same(const PiecesAsked& other) const;
};

/// The parts of a surface, at most `most`: beyond that, those of fewest triangles are left together as one that stays.
struct Pieces {
  static constexpr int most = 512;

  /// Throws Error if the mesh has no such array, or one of too many values.
  explicit Pieces(PiecesAsked asked);

  PiecesAsked asked;
  std::shared_ptr<const std::vector<std::uint32_t>> groups;  ///< of each triangle, the part's number
  std::vector<Piece> list;        ///< by number, ascending
  int numbers = 0;                ///< one more than the largest number
  int left_together = -1;         ///< index in `list` of what holds the parts that are too many; -1: none
  float radius = 0;               ///< of the sphere around all, world
  glm::vec3 center{0};            ///< of their box, world
};
