/// The view's lights as shaders read them.
#pragma once

#include <glm/vec4.hpp>

#include "frame/view_scene.h"

namespace lumenshop {

/// std140 block LumenLights of shaders/lib/lights.glsl.
struct LightBlock {
  glm::ivec4 count{0};  ///< x: of the lights
  struct {
    glm::vec4 place, color;
  } lights[16] = {};
};

/// What programs are made for, since a light of a known kind costs less.
struct LightKinds {
  int count = 0, points = 0;  ///< of all lights; of those that are points
};
LightKinds kinds_of(const LightBlock& lights);

LightBlock make_lights(const ViewScene& scene, const lumen::Camera& camera);

}  // namespace lumenshop
