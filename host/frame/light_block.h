/// The view's lights as shaders read them.
#pragma once

#include <glm/vec4.hpp>

#include "frame/view_scene.h"

namespace lumenshop {

/// std140 block LumenLights of shaders/lib/lights.glsl.
struct LightBlock {
  glm::ivec4 count{0};
  struct {
    glm::vec4 place, color;
  } lights[16] = {};
};

LightBlock make_lights(const ViewScene& scene, const lumen::Camera& camera);

}  // namespace lumenshop
