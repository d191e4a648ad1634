/// What closes both sides of a cut: triangles between the points of its lines.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <glm/vec3.hpp>

#include "cut.h"

struct Caps {
  std::vector<glm::uvec3> triangles;    ///< of the cut's points; as what lies below needs them, the other way around above
  std::vector<std::uint32_t> faces;     ///< which connected face of the caps each triangle is of
  std::vector<std::uint32_t> beside;    ///< of each face: a triangle of the cut that it adjoins
  std::size_t left_open = 0;            ///< lines that no face closes, since they cross themselves or others of their part
};

/// `place`: of a point in the plane. Lines that cross, since connected parts interpenetrate, are filled part by part.
Caps caps_of(const Cut& cut, const std::function<glm::vec2(std::uint32_t point)>& place);
