/// An explosion graph: in which order and along which axes parts come out, so that none moves through another. Li, Agrawala,
/// Curless, Salesin, Automated Generation of Interactive 3D Exploded View Diagrams, SIGGRAPH 2008.
#pragma once

#include <span>
#include <utility>

#include "blocking.h"

class ExplosionGraph {
 public:
  struct Asked {
    std::vector<int> fixed;   ///< parts that stay
    float gap = 0;            ///< world, between what was separated
    bool operator==(const Asked&) const = default;
  };
  ExplosionGraph(const Blocking& blocking, Asked asked);

  const Asked& asked() const { return asked_; }
  int stuck() const { return stuck_; }        ///< bodies that nothing frees, beside the one that all others leave
  int enclosed() const { return enclosed_; }  ///< parts that stay with another that holds them

  /// How far each part has moved, world: `degrees` 0..1 of each part is what is wanted; a part that is in the way of one that comes out
  /// comes out with it. No part moves through another, whatever is wanted and from whatever was wanted before.
  std::vector<glm::vec3> moves(std::span<const float> degrees) const;

 private:
  /// Parts that cannot be parted, and how they move.
  struct Body {
    std::vector<int> parts;
    lumen::Bounds bounds;      ///< in the frame
    bool fixed = false;
    Way way;
    float distance = 0;        ///< along the way, in all
    int level = 0;             ///< it moves while the degree goes over its level's share of 0..1
    std::vector<int> before;   ///< bodies that must be out as far, by the degree, as this one
  };

  void find_bodies(const Blocking& blocking);
  bool join_interlocked(const Blocking& blocking);
  Ways blocked(const Blocking& blocking, const Body& body, const Body& other) const;
  bool intersect(const Blocking& blocking, const Body& body, const Body& other) const;
  void find_order();
  void find_distances();
  void find_levels();
  float escape(int body, Way way, const std::vector<bool>& active) const;
  const Ways& ways(int body, int other) const { return ways_[std::size_t(body) * bodies_.size() + std::size_t(other)]; }
  bool near(int body, int other) const { return near_[std::size_t(body) * bodies_.size() + std::size_t(other)]; }
  bool meet(int body, int other) const { return meet_[std::size_t(body) * bodies_.size() + std::size_t(other)]; }

  Asked asked_;
  glm::mat3 axes_;
  float tolerance_ = 0;
  std::vector<Body> bodies_;
  std::vector<Ways> ways_;         ///< of pairs of bodies: blocked
  std::vector<bool> near_, meet_;  ///< of pairs of bodies: their boxes touch; they intersect at rest
  std::vector<int> order_;         ///< bodies as they come out; then those that stay
  std::size_t leaving_ = 0;        ///< how many of these come out
  int levels_ = 1, stuck_ = 0, enclosed_ = 0, parts_ = 0;
};
