/// The handle of a plane: where it is on the screen, what of it lies under the pointer, and what dragging that means. Pure values.
#pragma once

#include <utility>

#include <glm/gtc/quaternion.hpp>

#include <lumen/camera.h>

namespace plane_handle {

/// Where a plane is.
struct Pose {
  glm::vec3 center{0};         ///< world
  glm::quat turn{1, 0, 0, 0};  ///< turns +z to the normal
  bool operator==(const Pose&) const = default;
};

/// What can be held: the middle, the arrow along the normal, the rings about the plane's x and y axes.
enum class Part { none, middle, arrow, ring_x, ring_y };

// In lengths of the arrow; the shader has the same.
constexpr float middle_radius = 0.2f, ring_radius = 0.7f;

/// How directions are seen at a point: in parallel, as the camera sees them just there, so that a handle keeps its size on the screen.
/// Eye space: x right, y up, z against the view direction.
struct Sight {
  Sight(const lumen::Camera& camera, glm::ivec2 size, glm::vec3 point);

  bool in_front = true;         ///< of the eye
  glm::mat3 to_eye{1};          ///< world directions to eye space
  glm::vec2 pixel{0};           ///< of the point; origin top left
  glm::vec2 slant{0};           ///< how far across a unit toward the eye goes
  float world_per_pixel = 1, nearer_per_world = 0;  ///< the latter: 1 / distance along the view axis; 0: parallel

  /// Of an eye-space direction, across the screen with y up.
  glm::vec2 across(glm::vec3 direction) const { return glm::vec2(direction) + slant * direction.z; }
  /// Toward the eye, eye space, not unit: seen as nothing across the screen.
  glm::vec3 toward_eye() const { return {-slant, 1}; }
};

/// `length` of the arrow, `tolerance` beside lines: pixels.
Part part_at(const Pose& pose, const Sight& sight, float length, glm::vec2 pixel, float tolerance);

/// How the pose at the press changes with the pointer. `sight` is that of the press; pixels, origin top left.
/// Along the normal, so far that the middle follows the pointer. `step`: world, 0 = none.
Pose moved_along(const Pose& start, const Sight& sight, glm::vec2 from, glm::vec2 to, float step = 0);
/// At its distance from the eye, with the pointer.
Pose moved_across(const Pose& start, const Sight& sight, glm::vec2 from, glm::vec2 to, float step = 0);
/// About the ring's axis, so that what was held stays under the pointer. `step`: radians, 0 = none.
Pose turned(const Pose& start, Part ring, const Sight& sight, float length, glm::vec2 from, glm::vec2 to, float step = 0);

/// The side that is nearer to the eye turned to it, by the least turn.
Pose facing_eye(const Pose& pose, const Sight& sight);

/// A turn about an axis (any length; zero: none) by degrees, and back: the axis unit and not against `before`, so that it goes on
/// smoothly, the angle in -180..180.
glm::quat from_axis(glm::vec3 axis, float degrees);
std::pair<glm::vec3, float> to_axis(const glm::quat& turn, glm::vec3 before);

}  // namespace plane_handle
