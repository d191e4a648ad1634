/// Whether triangles that move along a coordinate axis without end would meet others: exact for each pair of triangles, by
/// separating axes of the one and the prism that the other sweeps; boxes only leave out pairs that cannot meet.
#pragma once

#include <cstdint>
#include <vector>

#include "pieces.h"

/// One of the six ways along the axes: +x, -x, +y, -y, +z, -z.
struct Way {
  int index = 0;
  static constexpr int count = 6;
  int axis() const { return index / 2; }
  float sign() const { return index % 2 == 0 ? 1.0f : -1.0f; }
  Way back() const { return {index ^ 1}; }
  glm::vec3 vector() const {
    glm::vec3 result(0);
    result[axis()] = sign();
    return result;
  }
  bool operator==(const Way&) const = default;
};

/// Triangles in a tree of boxes.
class TriangleTree {
 public:
  struct Node {
    lumen::Bounds bounds;
    std::uint32_t first = 0, count = 0;  ///< of triangles, in a leaf
    std::uint32_t right = 0;             ///< the other child; the first one follows its parent. 0: a leaf
  };
  explicit TriangleTree(std::vector<Corners> triangles);
  const std::vector<Node>& nodes() const { return nodes_; }  ///< the first is the root; none if there are no triangles
  const Corners& triangle(std::size_t i) const { return triangles_[i]; }

 private:
  void build(std::uint32_t first, std::uint32_t count);
  std::vector<Corners> triangles_;
  std::vector<Node> nodes_;
};

enum class Meeting { none, some, given_up };

/// Whether `moving` meets `still` on its way, deeper than `tolerance`: what only touches does not meet. Gives up after `most`
/// pairs of boxes and triangles.
Meeting meeting_on_way(const TriangleTree& moving, const TriangleTree& still, Way way, float tolerance, std::uint64_t most);
/// The same where both are.
Meeting meeting_at_rest(const TriangleTree& a, const TriangleTree& b, float tolerance, std::uint64_t most);
