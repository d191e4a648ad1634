/// Meshes made of the sides of a cut: their points, arrays and cells.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "caps.h"
#include "cut.h"

/// What the meshes of one cut share. It refers to all that it is made with.
class Pieces {
 public:
  /// `doubled`: caps have points of their own.
  Pieces(const lumen::Mesh& mesh, const Cut& cut, const Caps& caps, bool doubled);

  /// A side of the cut, moved.
  struct Piece {
    Side side = Side::above;
    glm::vec3 move{0};                  ///< in the mesh's space
  };
  /// All in one mesh, in this order.
  std::shared_ptr<lumen::Mesh> joined(const std::vector<Piece>& pieces, const std::string& origin) const;

 private:
  /// A point of a mesh that is being made.
  struct Point {
    Origin origin;
    glm::vec3 move{0};
    bool flat = false;                  ///< of a cap: without a normal, since the cap's own is that of its triangles
  };
  class Builder;

  void make_cells();
  std::vector<float> values_of(std::span<const Point> points, const lumen::Attribute& attribute) const;

  const lumen::Mesh& mesh_;
  const Cut& cut_;
  const Caps& caps_;
  bool doubled_;
  std::vector<bool> capped_;            ///< of each point of the cut: a cap ends there
  std::uint32_t cells_ = 0;             ///< of the mesh; caps have the numbers after them
  std::vector<lumen::Attribute> cell_arrays_;
};
