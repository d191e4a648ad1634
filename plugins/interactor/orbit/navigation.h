/// Where the eye is: the numbers of a camera that turns about a pivot, and what moves it. Pure values.
#pragma once

#include <optional>

#include <glm/gtc/quaternion.hpp>

#include <lumen/interactor.h>

namespace orbit {

struct Pose {
  glm::quat rotation{1, 0, 0, 0};  ///< world to eye
  glm::vec3 pivot{0};
  float distance = 1;              ///< eye to pivot, world
  float height = 2;                ///< of an orthographic view, world
  bool operator==(const Pose&) const = default;
};

/// What the projection adds.
struct Lens {
  bool orthographic = false;
  float field_of_view = 30;        ///< degrees, vertical
};

glm::mat4 view_matrix(const Pose& pose);

/// World units that a pixel covers at the pivot.
float world_per_pixel(const Pose& pose, const Lens& lens, glm::ivec2 size);

/// The pivot goes along, so that what is under the pointer stays under it.
Pose panned(const Pose& pose, const Lens& lens, glm::vec2 pixels, glm::ivec2 size);

/// Closer by `factor` (< 1: closer) with the point under the pointer at the pivot's depth staying in place.
Pose zoomed(const Pose& pose, const Lens& lens, float factor, glm::vec2 pointer, glm::ivec2 size);

/// Turned about the world's z (x pixels) and the eye's x (y pixels).
Pose turned(const Pose& pose, glm::vec2 pixels, glm::ivec2 size);

/// About the view axis, in degrees, counterclockwise.
Pose rolled(const Pose& pose, float degrees);

/// The whole bounding sphere in sight, with a margin of 5 %, at this aspect (width / height).
Pose fitted(const Pose& pose, const Lens& lens, const lumen::Bounds& bounds, float aspect);

/// Between two poses, 0..1, eased at both ends.
Pose between(const Pose& from, const Pose& to, float along);

/// "1" front, "3" right, "7" top; with `opposite` back, left, bottom. z is up, the front is seen along +y.
std::optional<glm::quat> standard_view(const std::string& key, bool opposite);

}  // namespace orbit
