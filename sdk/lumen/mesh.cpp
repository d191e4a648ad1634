/// Meshes: checks, bounds, averaged normals.
#include <lumen/mesh.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include <checks/data_check.h>
#include <lumen/error.h>

namespace lumen {

namespace {

std::uint32_t largest(std::span<const std::uint32_t> numbers) {
  // Plain processors compare signed numbers only; turned by half the range, they keep their order as such.
  constexpr std::uint32_t half = 1u << 31;
  std::int32_t most = std::numeric_limits<std::int32_t>::min();
  for (const std::uint32_t number : numbers) most = std::max(most, static_cast<std::int32_t>(number - half));
  return static_cast<std::uint32_t>(most) + half;
}

}  // namespace

std::size_t Mesh::bytes() const {
  return positions.view().size_bytes() + normals.view().size_bytes() + texture_coordinates.view().size_bytes() +
         triangles.view().size_bytes() + triangle_cells.view().size_bytes() + detail::bytes_of(attributes);
}

Bounds Mesh::bounds() const { return bounds_; }

std::string Mesh::summary() const { return grouped(triangles.size()) + " triangles, " + grouped(positions.size()) + " points"; }

const Attribute* Mesh::attribute(std::string_view name) const {
  const auto found = std::find_if(attributes.begin(), attributes.end(), [&](const Attribute& attribute) { return attribute.name == name; });
  return found == attributes.end() ? nullptr : &*found;
}

void Mesh::finish() {
  const auto fail = [&](const std::string& what) { throw Error(detail::name_of_origin(*this), what); };
  const auto check_per_point = [&](std::size_t size, const char* what) {
    if (size != 0 && size != positions.size()) fail(grouped(size) + " " + what + " for " + grouped(positions.size()) + " points");
  };
  check_per_point(normals.size(), "normals");
  check_per_point(texture_coordinates.size(), "texture coordinates");
  const Bounds bounds = detail::checked_bounds(*this, positions);
  detail::check_finite(*this, detail::numbers_of(normals), "normals");
  detail::check_finite(*this, detail::numbers_of(texture_coordinates), "texture coordinates");

  if (!triangles.empty()) {
    const std::uint32_t index = largest({&triangles.data()->x, triangles.size() * 3});
    if (index >= positions.size())
      fail("a triangle names point " + grouped(index) + "; there are " + grouped(positions.size()) + " (the first is 0)");
  }
  if (!triangle_cells.empty() && triangle_cells.size() != triangles.size())
    fail(grouped(triangle_cells.size()) + " cell numbers for " + grouped(triangles.size()) + " triangles");
  const bool own_cells = triangle_cells.empty();
  const std::size_t cells = own_cells ? triangles.size() : std::size_t{largest(triangle_cells)} + 1;
  detail::check_attributes(*this, attributes, positions.size(), cells, own_cells);
  bounds_ = bounds;
}

std::vector<glm::vec3> average_normals(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles) {
  std::vector<glm::vec3> normals(positions.size(), glm::vec3(0));
  for (const glm::uvec3& triangle : triangles) {
    const glm::vec3 origin = positions[triangle.x];
    // The cross product is twice the area long: the weighting comes by itself.
    const glm::vec3 normal = glm::cross(positions[triangle.y] - origin, positions[triangle.z] - origin);
    normals[triangle.x] += normal;
    normals[triangle.y] += normal;
    normals[triangle.z] += normal;
  }
  for (glm::vec3& normal : normals) {
    // Tiny and huge meshes leave the range in which squared lengths are exact: scale by the largest component first.
    const glm::vec3 size = glm::abs(normal);
    const float scale = std::max({size.x, size.y, size.z});
    normal = scale > 0 && std::isfinite(scale) ? glm::normalize(normal / scale) : glm::vec3(0);
  }
  return normals;
}

}  // namespace lumen
