#include "cube.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace view_cube {

int index_of(const Place& place) { return (place.x + 1) * 9 + (place.y + 1) * 3 + place.z + 1; }

glm::quat rotation_toward(const Place& place) {
  const glm::vec3 outward = glm::normalize(glm::vec3(place));
  const bool pole = place.x == 0 && place.y == 0;
  const glm::vec3 up = pole ? glm::vec3(0, place.z, 0) : glm::vec3(0, 0, 1);
  const glm::vec3 right = glm::normalize(glm::cross(up, outward));
  // Its rows are the eye's axes.
  return glm::normalize(glm::quat_cast(glm::transpose(glm::mat3(right, glm::cross(outward, right), outward))));
}

std::optional<Place> place_at(glm::vec2 point, const glm::quat& rotation) {
  const glm::mat3 to_world = glm::transpose(glm::mat3_cast(rotation));
  const glm::vec3 origin = to_world * glm::vec3(point / half_edge, 0), direction = to_world * glm::vec3(0, 0, -1);
  float enter = -1e30f, leave = 1e30f;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(direction[axis]) < 1e-7f) {
      if (std::abs(origin[axis]) > 1) return std::nullopt;
      continue;
    }
    const float a = (-1 - origin[axis]) / direction[axis], b = (1 - origin[axis]) / direction[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  if (enter > leave) return std::nullopt;
  const glm::vec3 hit = origin + enter * direction;
  Place place(0);
  for (int axis = 0; axis < 3; ++axis) place[axis] = hit[axis] > face_part ? 1 : hit[axis] < -face_part ? -1 : 0;
  return place;
}

}  // namespace view_cube
