/// The gallery's materials: what color a sphere has, as a formula.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

/// A place on the sphere, as the picture shows it: x right, y up, z out of the picture. All unit.
struct Place {
  glm::vec3 normal, to_light;
};

struct Material {
  const char* name;
  glm::vec3 (*color)(const Place& place);  ///< linear radiance
};

std::span<const Material> materials();
std::vector<std::string> material_names();
