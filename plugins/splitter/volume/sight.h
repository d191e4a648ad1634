/// What a picture of few pixels sees of interest, what hides it there, and how good a cut is for that. Sigg, Fuchs, Carnecky,
/// Peikert, Intelligent Cutaway Illustrations, PacificVis 2012.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <lumen/camera.h>
#include <lumen/mesh.h>

#include "cut.h"

class Sight {
 public:
  /// `depths`: of what is of interest, rows bottom-up, eye distances along the axis; infinite elsewhere.
  Sight(const lumen::Camera& camera, glm::ivec2 size, std::vector<float> depths);

  /// Adds the triangles, of group 0 if there are groups, that lie before what is of interest. `close`, world: what is nearer to it
  /// than this does not hide it.
  void add(const lumen::Mesh& mesh, const glm::mat4& object_to_world, std::span<const std::uint32_t> groups, float close);

  bool hidden() const { return !hiding_.empty(); }
  /// f = 1/d sum(alpha A_pos - A_neg) - beta V over the d pixels of interest: A_pos is 1 where the cut leaves it in sight, A_neg
  /// where it does not; V is the cut's share of `whole`, world units cubed.
  float worth(const Cut& cut, float alpha, float beta, float whole) const;

  struct Hiding {
    int pixel;        ///< number among those of interest
    glm::vec3 place;  ///< world
  };
  const std::vector<Hiding>& hiding() const { return hiding_; }
  const std::vector<glm::vec3>& interest() const { return interest_; }  ///< world

 private:
  glm::vec3 seen(glm::vec3 world) const;  ///< pixels, and the depth
  glm::vec3 world(glm::vec2 pixel, float depth) const;

  lumen::Camera camera_;
  glm::mat4 to_world_;
  glm::vec2 size_;
  float pixel_;                     ///< width at depth 1, orthographic: anywhere; world
  std::vector<float> depths_;
  std::vector<int> number_;         ///< of each pixel among those of interest, -1: none
  std::vector<glm::vec3> interest_;
  std::vector<Hiding> hiding_;
};

/// The cut of the most worth that a search from a few places finds, center and size free as told; the same for the same sight.
Cut placed(const Sight& sight, const Cut& begin, bool move, bool scale, float alpha, float beta, float whole);
