#include <lumen/arcball.h>

#include <algorithm>
#include <cmath>

namespace lumen {

glm::quat arcball(glm::vec2 from, glm::vec2 to, glm::ivec2 size) {
  const float radius = 0.5f * static_cast<float>(std::max(1, std::min(size.x, size.y)));
  const auto on_ball = [&](glm::vec2 pixel) {
    const glm::vec2 p = glm::vec2(pixel.x - 0.5f * static_cast<float>(size.x), 0.5f * static_cast<float>(size.y) - pixel.y) / radius;
    const float squared = glm::dot(p, p);
    return glm::normalize(glm::vec3(p, squared <= 0.5f ? std::sqrt(1 - squared) : 0.5f / std::sqrt(squared)));
  };
  const glm::vec3 a = on_ball(from), b = on_ball(to);
  const glm::vec3 axis = glm::cross(a, b);
  const float sine = glm::length(axis);
  if (sine < 1e-7f) return {1, 0, 0, 0};
  // Twice the angle on the ball, as Shoemake has it: then a drag across the ball turns it once around.
  return glm::angleAxis(2 * std::atan2(sine, glm::dot(a, b)), axis / sine);
}

}  // namespace lumen
