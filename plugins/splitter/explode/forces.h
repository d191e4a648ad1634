/// A force-directed layout of parts around a selection that stays. Bruckner, Groeller, Exploded Views for Volume Data, IEEE
/// Transactions on Visualization and Computer Graphics 12(5), 2006, section 3.2.
///
/// On each part act, r in radii of the surface, c the strengths:
///   return     c ln(1 + |r|)       toward where it was; r from there. The paper's logarithm, shifted to be 0 at rest
///   explosion  c exp(-|r|)         away from points of the selection; r from the point to the nearest of the part's box
///   viewing    c / |r|             away from the rays of the eye through these points; r from the ray to the part's center. Behind the
///                                  point, where a part hides nothing, there is none
///   spacing    c / |r|^2           away from the other parts; r between the centers
/// The second and third are means over the points, the last over the parts. All but the return force are multiplied by the part's
/// degree of explosion. Poles are flattened: |r| is no less than a twentieth. Without a selection, parts also move the less the larger their
/// share of the area is, so that small ones leave a large one and not the other way round.
#pragma once

#include <span>

#include "pieces.h"

struct Strengths {
  float back = 1, explosion = 0.7f, viewing = 0.3f, spacing = 0.05f;
  bool operator==(const Strengths&) const = default;
};

class ForceLayout {
 public:
  /// `fixed`: indices of parts that stay and that the others leave; none: they leave the center of all.
  ForceLayout(const Pieces& pieces, std::vector<int> fixed);

  const std::vector<int>& fixed() const { return fixed_; }
  /// Whether the camera matters.
  bool views(const Strengths& strengths) const { return !fixed_.empty() && strengths.viewing > 0; }
  /// How far each part has moved where the forces are in equilibrium, world: found from rest in a bounded number of steps, so that it depends
  /// on nothing else. `degrees`: of each part, 0..1; exactly none where they are 0.
  std::vector<glm::vec3> moves(std::span<const float> degrees, const Strengths& strengths, const lumen::Camera& camera) const;

 private:
  /// In radii, from the center of all.
  struct Block {
    glm::vec3 center, low, high;
    float radius = 0;
    float ease = 1;            ///< how much of the forces acts: 0 does not move
    glm::vec3 aside{1, 0, 0};  ///< where it goes if nothing says
  };
  glm::vec3 force(std::size_t part, std::span<const glm::vec3> moves, float degree, const Strengths& strengths, std::span<const glm::vec3> rays) const;

  std::vector<int> fixed_;
  std::vector<Block> blocks_;
  std::vector<glm::vec3> points_;  ///< of the selection, spread over it
  glm::vec3 center_{0};
  float radius_ = 1;               ///< world
};
