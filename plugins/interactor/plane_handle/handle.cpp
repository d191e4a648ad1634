#include "handle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace plane_handle {
namespace {

/// An arrow that points at the eye is no longer than this on the screen: it could not be pulled.
constexpr float shortest_arrow = 0.2f;
/// Rings whose axes lie that far across the view are turned by the way along them.
constexpr float edge_on = 0.35f;

glm::vec3 eye_axis(const Pose& pose, const Sight& sight, glm::vec3 axis) { return sight.to_eye * (pose.turn * axis); }

/// Pixels to world units at the point, y up.
glm::vec2 in_world(const Sight& sight, glm::vec2 pixels) { return glm::vec2(pixels.x, -pixels.y) * sight.world_per_pixel; }

float snapped(float value, float step) { return step > 0 ? step * std::round(value / step) : value; }

/// Where the line of sight through a place across the screen meets the plane through the point with this normal; eye space.
glm::vec3 on_plane(glm::vec2 place, glm::vec3 normal, const Sight& sight) {
  const glm::vec3 eye = sight.toward_eye();
  const float facing = glm::dot(normal, eye), safe = std::abs(facing) < 1e-4f ? std::copysign(1e-4f, facing) : facing;
  return glm::vec3(place, 0) - glm::dot(glm::vec2(normal), place) / safe * eye;
}

float to_segment(glm::vec2 at, glm::vec2 a, glm::vec2 b) {
  const glm::vec2 path = b - a;
  const float square = glm::dot(path, path);
  const float along = square > 0 ? std::clamp(glm::dot(at - a, path) / square, 0.0f, 1.0f) : 0.0f;
  return glm::length(at - a - along * path);
}

/// In units of `at`: the distance to a unit circle's image.
float to_ring(glm::vec2 at, glm::vec3 u, glm::vec3 v, const Sight& sight) {
  constexpr int corners = 64;
  float nearest = 1e30f;
  glm::vec2 before = sight.across(u);
  for (int i = 1; i <= corners; ++i) {
    const float angle = 2 * std::numbers::pi_v<float> * float(i) / corners;
    const glm::vec2 next = sight.across(std::cos(angle) * u + std::sin(angle) * v);
    nearest = std::min(nearest, to_segment(at, before, next));
    before = next;
  }
  return nearest;
}

}  // namespace

Sight::Sight(const lumen::Camera& camera, glm::ivec2 size, glm::vec3 point) : to_eye(camera.view) {
  const glm::vec3 eye = camera.view * glm::vec4(point, 1);
  in_front = camera.orthographic || eye.z < 0;
  const float height = float(std::max(size.y, 1)), distance = std::max(-eye.z, 1e-12f);
  const float visible = camera.orthographic ? camera.height : 2 * distance * std::tan(glm::radians(0.5f * camera.field_of_view));
  world_per_pixel = visible / height;
  if (!camera.orthographic) {
    slant = glm::vec2(eye) / distance;
    nearer_per_world = 1 / distance;
  }
  pixel = 0.5f * glm::vec2(size) + glm::vec2(eye.x, -eye.y) / world_per_pixel;
}

Part part_at(const Pose& pose, const Sight& sight, float length, glm::vec2 pixel, float tolerance) {
  if (!sight.in_front || length <= 0) return Part::none;
  const glm::vec2 at = glm::vec2(pixel.x - sight.pixel.x, sight.pixel.y - pixel.y) / length;
  const float near = tolerance / length;
  const glm::vec3 x = eye_axis(pose, sight, {1, 0, 0}), y = eye_axis(pose, sight, {0, 1, 0}), normal = eye_axis(pose, sight, {0, 0, 1});
  if (glm::length(at) <= near || glm::length(on_plane(at, normal, sight)) <= middle_radius) return Part::middle;
  const glm::vec2 tip = sight.across(normal);
  if (glm::length(tip) >= shortest_arrow && to_segment(at, middle_radius * tip, tip) <= near) return Part::arrow;
  const float about_x = to_ring(at / ring_radius, y, normal, sight), about_y = to_ring(at / ring_radius, x, normal, sight);
  if (std::min(about_x, about_y) * ring_radius > near) return Part::none;
  return about_x < about_y ? Part::ring_x : Part::ring_y;
}

Pose moved_along(const Pose& start, const Sight& sight, glm::vec2 from, glm::vec2 to, float step) {
  const glm::vec3 normal = eye_axis(start, sight, {0, 0, 1});
  const glm::vec2 arrow = sight.across(normal);
  const float shown = glm::length(arrow);
  if (shown == 0) return start;
  const float way = glm::dot(in_world(sight, to - from), arrow / shown);
  // In perspective a point that comes nearer goes further on the screen; it never gets to where the arrow's line vanishes.
  const float per_world = std::max(shown + way * sight.nearer_per_world * normal.z, 0.05f * shown);
  Pose moved = start;
  moved.center += start.turn * glm::vec3(0, 0, snapped(way / per_world, step));
  return moved;
}

Pose moved_across(const Pose& start, const Sight& sight, glm::vec2 from, glm::vec2 to, float step) {
  const glm::vec2 way = in_world(sight, to - from);
  Pose moved = start;
  moved.center += glm::transpose(sight.to_eye) * glm::vec3(snapped(way.x, step), snapped(way.y, step), 0);
  return moved;
}

Pose turned(const Pose& start, Part ring, const Sight& sight, float length, glm::vec2 from, glm::vec2 to, float step) {
  const glm::vec3 own = ring == Part::ring_x ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  const glm::vec3 axis = eye_axis(start, sight, own), eye = glm::normalize(sight.toward_eye());
  float angle = 0;
  if (std::abs(glm::dot(axis, eye)) > edge_on) {
    const auto held = [&](glm::vec2 pixel) { return on_plane({pixel.x - sight.pixel.x, sight.pixel.y - pixel.y}, axis, sight); };
    const glm::vec3 a = held(from), b = held(to);
    angle = std::atan2(glm::dot(axis, glm::cross(a, b)), glm::dot(a, b));
  } else {
    // The point of the ring that is nearest to the eye follows.
    const glm::vec2 along = sight.across(glm::cross(axis, glm::normalize(eye - axis * glm::dot(axis, eye))));
    const glm::vec2 way(to.x - from.x, from.y - to.y);
    angle = glm::dot(way, along) / (glm::dot(along, along) * ring_radius * length);
  }
  Pose result = start;
  result.turn = glm::normalize(start.turn * glm::angleAxis(snapped(angle, step), own));
  return result;
}

Pose facing_eye(const Pose& pose, const Sight& sight) {
  const glm::vec3 eye = glm::transpose(sight.to_eye) * glm::normalize(sight.toward_eye()), normal = pose.turn * glm::vec3(0, 0, 1);
  const glm::vec3 side = glm::dot(normal, eye) < 0 ? -normal : normal, axis = glm::cross(side, eye);
  const float sine = glm::length(axis);
  Pose result = pose;
  if (sine > 1e-7f) result.turn = glm::normalize(glm::angleAxis(std::atan2(sine, glm::dot(side, eye)), axis / sine) * pose.turn);
  return result;
}

glm::quat from_axis(glm::vec3 axis, float degrees) {
  return glm::dot(axis, axis) > 0 ? glm::angleAxis(glm::radians(degrees), glm::normalize(axis)) : glm::quat(1, 0, 0, 0);
}

std::pair<glm::vec3, float> to_axis(const glm::quat& turn, glm::vec3 before) {
  const glm::quat near = turn.w < 0 ? -turn : turn;
  const glm::vec3 along(near.x, near.y, near.z);
  const float sine = glm::length(along);
  if (sine < 1e-6f) return {glm::dot(before, before) > 0 ? glm::normalize(before) : glm::vec3(0, 0, 1), 0.0f};
  const float degrees = std::min(180.0f, glm::degrees(2 * std::atan2(sine, near.w)));
  return glm::dot(along, before) < 0 ? std::pair(-along / sine, -degrees) : std::pair(along / sine, degrees);
}

}  // namespace plane_handle
