/// A cut volume as one sees and holds it: its outline, its handles, and what dragging these makes of it.
#pragma once

#include <string>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include <lumen/camera.h>

namespace cut_volume {

/// As splitter.volume declares it.
struct Shape {
  std::string kind;  ///< sphere, box, wedge or tube
  glm::vec3 center{0};
  glm::quat rotation{1, 0, 0, 0};
  float radius = 0;
  glm::vec3 size{0};
  float length = 0;
  float angle = 0;   ///< degrees

  glm::vec3 world(glm::vec3 own) const { return center + rotation * own; }
};

struct Handle {
  enum class Grip { move, radius, size, length, angle };
  Grip grip = Grip::move;
  glm::vec3 place{0};      ///< world
  glm::vec3 direction{0};  ///< world, unit: along which it is dragged; none for move and angle
  int axis = 0;            ///< of size
};

/// The line of sight through a pixel, world.
struct Ray {
  glm::vec3 origin{0}, direction{0};  ///< direction unit
};

/// The middle first.
std::vector<Handle> handles_of(const Shape& shape, const lumen::Camera& camera);
/// Polylines, world.
std::vector<std::vector<glm::vec3>> outlines_of(const Shape& shape, const lumen::Camera& camera);
/// What the volume becomes when the handle goes from one ray to the other: a face of a box, an end of wedge and tube moves alone.
Shape dragged(const Shape& shape, const Handle& handle, const Ray& from, const Ray& to, const lumen::Camera& camera);

}  // namespace cut_volume
