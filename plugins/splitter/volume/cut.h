/// The volume that splitter.volume cuts out, as its shader has it.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

struct Cut {
  enum class Shape { sphere, box, wedge, tube };
  Shape shape = Shape::sphere;
  glm::vec3 center{0};
  glm::quat rotation{1, 0, 0, 0};
  float radius = 0;     ///< world
  glm::vec3 size{0};    ///< world, of the box
  float length = 0;     ///< world, of wedge and tube
  float angle = 90;     ///< degrees, of the wedge

  bool holds(glm::vec3 world) const;
  float volume() const;  ///< world units, cubed
  /// The same, all its lengths times a factor.
  Cut scaled(float factor) const;
};
