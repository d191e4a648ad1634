/// Camera and light: what interactors give to a view.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <lumen/value.h>

namespace lumen {

/// Looks along -z of view space, which is right-handed.
struct Camera {
  glm::mat4 view{1};             ///< world to view space, rigid
  bool orthographic = false;
  float field_of_view = 30;      ///< degrees, vertical; perspective
  float height = 2;              ///< world units, vertical; orthographic
  glm::vec3 pivot{0};            ///< world; what it turns about
  float distance = 1;            ///< world, eye to pivot
  bool operator==(const Camera&) const = default;
};

struct Light {
  enum class Falloff { none, linear, quadratic };
  bool point = false;
  glm::vec3 direction{0, 0, 1};  ///< toward the light, world, unit; directional
  glm::vec3 position{0};         ///< world; point
  glm::vec3 color{1};            ///< linear, times the intensity
  Falloff falloff = Falloff::none;  ///< by the distance in world units
  bool operator==(const Light&) const = default;
};

}  // namespace lumen
