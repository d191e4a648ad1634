/// The 26 places of a cube that one can look from, and which of them is under a pixel. Pure values.
#pragma once

#include <optional>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace view_cube {

/// A place is where its outward direction has a sign: (0, -1, 0) the face toward -y, (1, 0, 1) an edge, (1, 1, 1) a corner.
using Place = glm::ivec3;

/// 0..26 without 13, which is no place.
int index_of(const Place& place);
constexpr int nowhere = 13;

/// World to eye, so that the eye is on the side of the place, with z up; from the poles y up or down.
glm::quat rotation_toward(const Place& place);

/// The place under a point of the cube's picture, -1..1 each way with y up, when the cube is turned by `rotation`.
std::optional<Place> place_at(glm::vec2 point, const glm::quat& rotation);

/// How much of half the picture half the cube's edge is: room for its corners and the lights around it.
constexpr float half_edge = 0.46f;
/// The part of a face, from its middle, that is the face's own and not its edges' or corners'.
constexpr float face_part = 0.62f;

}  // namespace view_cube
