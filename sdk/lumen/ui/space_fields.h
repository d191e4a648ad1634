/// Fields of rotations and matrices.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>

#include <lumen/ui/edit.h>
#include <lumen/ui/number_field.h>

namespace lumen::ui {

/// Degrees about x, then y, then z of space, each -180..180.
glm::vec3 euler_of(const glm::quat& rotation);
glm::quat rotation_of(glm::vec3 degrees);

/// A ball to drag (Ctrl: steps of 15 degrees) and the three angles.
Edit rotation_field(const char* id, glm::quat& rotation, float width, const FieldStyle& style = {});

/// Sixteen numbers, folded away at first. Shown row by row.
Edit matrix_field(const char* id, glm::mat4& matrix, float width, const FieldStyle& style = {});

}  // namespace lumen::ui
