#include "cut.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

bool Cut::holds(glm::vec3 world) const {
  const glm::vec3 arm = world - center;
  if (shape == Shape::sphere) return glm::dot(arm, arm) <= radius * radius;
  const glm::vec3 own = glm::conjugate(rotation) * arm;
  if (shape == Shape::box) return glm::all(glm::lessThanEqual(glm::abs(own), 0.5f * size));
  if (std::abs(own.z) > 0.5f * length || own.x * own.x + own.y * own.y > radius * radius) return false;
  const float half = 0.5f * glm::radians(angle);
  return shape == Shape::tube || std::abs(own.y) * std::cos(half) <= own.x * std::sin(half);
}

float Cut::volume() const {
  const float disk = glm::pi<float>() * radius * radius;
  switch (shape) {
    case Shape::sphere: return 4 * disk * radius / 3;
    case Shape::box: return size.x * size.y * size.z;
    case Shape::wedge: return disk * length * angle / 360;
    case Shape::tube: return disk * length;
  }
  return 0;
}

Cut Cut::scaled(float factor) const {
  Cut other = *this;
  other.radius *= factor;
  other.size *= factor;
  other.length *= factor;
  return other;
}
