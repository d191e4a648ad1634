/// The meshes of lumen/testing.h.
#include <lumen/testing.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lumen::testing {
namespace {

struct Parts {
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::uvec3> triangles;

  void quad(glm::vec3 corner, glm::vec3 right, glm::vec3 up) {
    const auto first = std::uint32_t(positions.size());
    const glm::vec3 normal = glm::normalize(glm::cross(right, up));
    for (const glm::vec3 position : {corner, corner + right, corner + right + up, corner + up}) {
      positions.push_back(position);
      normals.push_back(normal);
    }
    triangles.emplace_back(first, first + 1, first + 2);
    triangles.emplace_back(first, first + 2, first + 3);
  }
  std::shared_ptr<Mesh> mesh(const char* origin) {
    auto result = std::make_shared<Mesh>();
    result->positions = std::move(positions);
    result->normals = std::move(normals);
    result->triangles = std::move(triangles);
    result->origin = origin;
    result->finish();
    return result;
  }
};

}  // namespace

std::shared_ptr<Mesh> sphere(int segments, float radius) {
  segments = std::max(segments, 3);
  const int rings = std::max(segments / 2, 2);
  Parts parts;
  for (int ring = 0; ring <= rings; ++ring) {
    const double latitude = std::numbers::pi * ring / rings;
    // Exactly, so that the points of a pole and of the seam are at one place and the surface is closed.
    const double around = ring % rings == 0 ? 0 : std::sin(latitude);
    for (int segment = 0; segment <= segments; ++segment) {
      const double longitude = 2 * std::numbers::pi * (segment % segments) / segments;
      const glm::vec3 normal(around * std::cos(longitude), std::cos(latitude), -around * std::sin(longitude));
      parts.normals.push_back(normal);
      parts.positions.push_back(radius * normal);
    }
  }
  const auto index = [&](int ring, int segment) { return std::uint32_t(ring * (segments + 1) + segment); };
  for (int ring = 0; ring < rings; ++ring)
    for (int segment = 0; segment < segments; ++segment) {
      const std::uint32_t a = index(ring, segment), b = index(ring + 1, segment), c = index(ring + 1, segment + 1), d = index(ring, segment + 1);
      if (ring + 1 < rings) parts.triangles.emplace_back(a, b, c);
      if (ring > 0) parts.triangles.emplace_back(a, c, d);
    }
  return parts.mesh("sphere");
}

std::shared_ptr<Mesh> rectangle(float width, float height) {
  Parts parts;
  parts.quad({-0.5f * width, -0.5f * height, 0}, {width, 0, 0}, {0, height, 0});
  return parts.mesh("rectangle");
}

std::shared_ptr<Mesh> box(glm::vec3 size) {
  const glm::vec3 low = -0.5f * size, x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z);
  Parts parts;
  parts.quad(low + z, x, y);
  parts.quad(low, y, x);
  parts.quad(low + x, y, z);
  parts.quad(low, z, y);
  parts.quad(low + y, z, x);
  parts.quad(low, x, z);
  return parts.mesh("box");
}

std::shared_ptr<Mesh> moved(const Mesh& mesh, glm::vec3 offset) {
  auto result = std::make_shared<Mesh>(mesh);
  std::vector<glm::vec3> positions(mesh.positions.begin(), mesh.positions.end());
  for (glm::vec3& position : positions) position += offset;
  result->positions = std::move(positions);
  result->finish();
  return result;
}

std::shared_ptr<Mesh> joined(const std::vector<std::shared_ptr<Mesh>>& meshes) {
  Parts parts;
  for (const auto& mesh : meshes) {
    const auto first = std::uint32_t(parts.positions.size());
    parts.positions.insert(parts.positions.end(), mesh->positions.begin(), mesh->positions.end());
    parts.normals.insert(parts.normals.end(), mesh->normals.begin(), mesh->normals.end());
    for (const glm::uvec3 triangle : mesh->triangles) parts.triangles.push_back(triangle + first);
  }
  return parts.mesh("joined");
}

}  // namespace lumen::testing
