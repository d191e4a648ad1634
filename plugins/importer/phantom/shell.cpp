/// Appending and handing over.
#include "shell.h"

void Shell::reserve(std::size_t triangle_count) {
  // A closed surface has about half as many points as triangles.
  const std::size_t points = triangle_count / 2 + 64;
  positions.reserve(positions.size() + points);
  normals.reserve(normals.size() + points);
  radius.reserve(radius.size() + points);
  pressure.reserve(pressure.size() + points);
  triangles.reserve(triangles.size() + triangle_count);
}

std::uint32_t Shell::add(glm::vec3 position, float distance, float mmhg) {
  positions.push_back(position);
  normals.emplace_back(0);
  radius.push_back(distance);
  pressure.push_back(mmhg);
  return static_cast<std::uint32_t>(positions.size() - 1);
}

void Shell::append(const Shell& other) {
  const auto base = static_cast<std::uint32_t>(positions.size());
  positions.insert(positions.end(), other.positions.begin(), other.positions.end());
  normals.insert(normals.end(), other.normals.begin(), other.normals.end());
  radius.insert(radius.end(), other.radius.begin(), other.radius.end());
  pressure.insert(pressure.end(), other.pressure.begin(), other.pressure.end());
  for (const glm::uvec3& triangle : other.triangles) triangles.push_back(triangle + base);
}

std::shared_ptr<lumen::Mesh> mesh_of(Shell shell, const std::string& origin) {
  auto mesh = std::make_shared<lumen::Mesh>();
  mesh->origin = origin;
  // The anatomy is modeled with y upward and the front toward +z; patients stand with z upward and face -y.
  for (auto* vectors : {&shell.positions, &shell.normals})
    for (glm::vec3& v : *vectors) v = {v.x, -v.z, v.y};
  mesh->positions = std::move(shell.positions);
  mesh->normals = std::move(shell.normals);
  mesh->triangles = std::move(shell.triangles);
  mesh->attributes.push_back({"radius", lumen::Attribute::On::points, 1, std::move(shell.radius)});
  mesh->attributes.push_back({"pressure", lumen::Attribute::On::points, 1, std::move(shell.pressure)});
  return mesh;
}
