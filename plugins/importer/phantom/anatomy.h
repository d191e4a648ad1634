/// The shape of a dissected aorta: its course, its branches, the true lumen and where the flap hangs. Millimeters;
/// x to the patient's left, y up, z to the front.
#pragma once

#include <memory>
#include <vector>

#include "tube.h"

struct AnatomyOptions {
  int seed = 1;                ///< of the irregularities
  float bend = 1;              ///< 0 straight .. 1 a natural arch
  float twist = 0.6f;          ///< turns of the flap around the axis
  float irregularity = 0.03f;  ///< of the radius
  float false_lumen = 0.65f;   ///< share of the section, 0.3..0.85
  bool branches = true;
};

/// What is dissected: the false lumen opens and closes smoothly between two arc lengths.
class Dissection {
 public:
  Dissection(const Centerline& line, const AnatomyOptions& options);

  float begin() const { return begin_; }
  float end() const { return end_; }
  float opening(float distance) const;             ///< 0 healthy .. 1 fully split
  glm::vec2 direction(float distance) const;       ///< toward the false lumen, unit, in the plane of right and up
  float inner_radius(const CurveFrame& frame) const { return 0.88f * frame.radius; }  ///< of the wall's inside
  /// How far the membrane lies from the axis toward the false lumen, in inner radii: 1 at the wall.
  float membrane(float distance) const;

 private:
  float begin_, end_, twist_, phase_, closed_share_;
};

class Anatomy {
 public:
  explicit Anatomy(const AnatomyOptions& options);
  ~Anatomy();

  const Centerline& aorta() const { return *aorta_; }
  const Dissection& dissection() const { return *dissection_; }
  const std::vector<Tube>& wall() const { return wall_; }  ///< the aorta first, then its branches
  const Tube& lumen() const { return lumen_; }

 private:
  std::unique_ptr<Centerline> aorta_;
  std::unique_ptr<Dissection> dissection_;
  std::vector<std::unique_ptr<Centerline>> branch_lines_;
  std::vector<std::unique_ptr<CrossSection>> sections_;
  std::vector<Tube> wall_;
  Tube lumen_;
};
