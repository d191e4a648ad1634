/// Normals of meshes without any: Max, Weights for Computing Vertex Normals from Facet Normals, Journal of Graphics Tools 1999.
#include "welded_surface.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/geometric.hpp>

namespace {

constexpr std::size_t progress_step = 1 << 14;

bool lies_before(const glm::vec3& a, const glm::vec3& b) {
  return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

glm::dvec3 unit(glm::dvec3 vector) {
  const double length = glm::length(vector);
  return length > 0 ? vector / length : glm::dvec3(0);
}

/// The mesh's points with those of each place behind one another.
std::vector<std::uint32_t> ordered_by_place(const lumen::Mesh& mesh) {
  std::vector<std::uint32_t> order(mesh.positions.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return lies_before(mesh.positions[a], mesh.positions[b]); });
  return order;
}

/// The sum of the triangles' normals at each point, each over the squared lengths of its edges there: exact on a sphere.
std::vector<glm::dvec3> normals_of(const WeldedSurface& surface) {
  std::vector<glm::dvec3> normals(surface.positions.size(), glm::dvec3(0));
  for (const glm::uvec3& t : surface.triangles)
    for (int corner = 0; corner < 3; ++corner) {
      const glm::dvec3& at = surface.positions[t[corner]];
      const glm::dvec3 a = surface.positions[t[(corner + 1) % 3]] - at, b = surface.positions[t[(corner + 2) % 3]] - at;
      const double squares = glm::dot(a, a) * glm::dot(b, b);
      if (squares > 0) normals[t[corner]] += glm::cross(a, b) / squares;
    }
  for (glm::dvec3& normal : normals) normal = unit(normal);
  return normals;
}

}  // namespace

WeldedSurface welded(const lumen::Mesh& mesh, double crease, const std::function<void(float)>& progress) {
  WeldedSurface result;
  const glm::dvec3 center(mesh.bounds().center());
  if (const double radius = mesh.bounds().radius(); radius > 0) result.unit = radius;
  result.number.resize(mesh.positions.size());
  const bool has_normals = !mesh.normals.empty();
  const double least = std::cos(crease);
  const std::vector<std::uint32_t> order = ordered_by_place(mesh);
  std::vector<glm::dvec3> leaders;  // of the points at the place, the first normal of each
  for (std::size_t begin = 0, end; begin < order.size(); begin = end) {
    const glm::vec3& place = mesh.positions[order[begin]];
    const std::size_t first = result.positions.size();
    leaders.clear();
    for (end = begin; end < order.size() && mesh.positions[order[end]] == place; ++end) {
      if (end % progress_step == 0) progress(float(end) / float(order.size()));
      const glm::dvec3 normal(has_normals ? mesh.normals[order[end]] : glm::vec3(0));
      const auto leader = std::find_if(leaders.begin(), leaders.end(), [&](const glm::dvec3& other) { return !has_normals || glm::dot(normal, other) >= least; });
      const std::size_t number = first + std::size_t(leader - leaders.begin());
      if (leader == leaders.end()) {
        leaders.push_back(normal);
        result.positions.push_back((glm::dvec3(place) - center) / result.unit);
        result.normals.push_back(glm::dvec3(0));
      }
      result.normals[number] += normal;
      result.number[order[end]] = std::uint32_t(number);
    }
  }
  result.triangles.reserve(mesh.triangles.size());
  for (const glm::uvec3& t : mesh.triangles) result.triangles.emplace_back(result.number[t.x], result.number[t.y], result.number[t.z]);
  if (has_normals) {
    for (glm::dvec3& normal : result.normals) normal = unit(normal);
  } else {
    result.normals = normals_of(result);
  }
  return result;
}
