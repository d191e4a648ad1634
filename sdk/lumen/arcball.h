/// The arcball: dragging turns as if a ball under the pointer were held.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>

namespace lumen {

/// The rotation, in eye space (x right, y up, z toward the eye), that a drag means. Pixels of a view, origin top left.
/// The ball fills the shorter side; beyond it a hyperbolic sheet continues it without a seam (Holroyd), so that every
/// drag turns, and going back undoes it.
glm::quat arcball(glm::vec2 from, glm::vec2 to, glm::ivec2 size);

}  // namespace lumen
