/// Which parts of a surface are in each other's way, along six directions.
#pragma once

#include <bitset>
#include <memory>

#include "sweep.h"

/// Directions along which something is blocked.
using Ways = std::bitset<Way::count>;

/// For all pairs of parts, in a frame whose axes are the directions.
class Blocking {
 public:
  /// `axes`: columns are the frame's axes, unit, world.
  Blocking(const Pieces& pieces, const glm::mat3& axes);

  int count() const { return count_; }
  const glm::mat3& axes() const { return axes_; }
  const lumen::Bounds& bounds(int part) const { return bounds_[std::size_t(part)]; }  ///< in the frame
  /// The ways on which `part` would move through `other`, if that stays.
  const Ways& ways(int part, int other) const { return ways_[index(part, other)]; }
  /// Both meet where they are: they block nothing of each other, since there is no way to move them apart without.
  bool intersect(int part, int other) const { return intersect_[index(part, other)]; }
  int intersecting() const { return intersecting_; }  ///< pairs
  int given_up() const { return given_up_; }          ///< pairs that are taken to be blocked because they have too many triangles
  float tolerance() const { return tolerance_; }      ///< world; what meets less than that deep only touches

 private:
  std::size_t index(int part, int other) const { return std::size_t(part) * std::size_t(count_) + std::size_t(other); }
  void find_pair(int a, int b, const TriangleTree& tree_a, const TriangleTree& tree_b);

  int count_ = 0;
  glm::mat3 axes_{1};
  float tolerance_ = 0;
  std::vector<lumen::Bounds> bounds_;
  std::vector<Ways> ways_;
  std::vector<bool> intersect_;
  int intersecting_ = 0, given_up_ = 0;
};

/// The directions in which the triangles' area spreads most and least, as columns, right-handed, each with its largest component positive
/// but for the last; the world's axes where there is no difference.
glm::mat3 principal_axes(const Pieces& pieces);
