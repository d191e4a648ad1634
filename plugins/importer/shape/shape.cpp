/// Simple surfaces with exact normals: what techniques are tried on before real data.

#include <cmath>
#include <numbers>

#include <lumen/importer.h>
#include <lumen/mesh.h>

namespace {

/// Counterclockwise from outside.
struct Triangles {
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::uvec3> triangles;

  std::uint32_t add(glm::vec3 position, glm::vec3 normal) {
    positions.push_back(position);
    normals.push_back(normal);
    return std::uint32_t(positions.size() - 1);
  }
  void quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    triangles.emplace_back(a, b, c);
    triangles.emplace_back(a, c, d);
  }
};

/// A ball of `detail` meridians and half as many parallels; each pole is one point.
Triangles sphere(float radius, int detail) {
  const int rings = std::max(detail / 2, 2), around = std::max(detail, 3);
  Triangles result;
  const auto add = [&](double latitude, double longitude) {
    const glm::vec3 normal(std::sin(latitude) * std::cos(longitude), std::sin(latitude) * std::sin(longitude), std::cos(latitude));
    return result.add(radius * normal, normal);
  };
  const std::uint32_t top = add(0, 0);
  for (int ring = 1; ring < rings; ++ring)
    for (int i = 0; i < around; ++i) add(std::numbers::pi * ring / rings, 2 * std::numbers::pi * i / around);
  const std::uint32_t bottom = add(std::numbers::pi, 0);
  const auto at = [&](int ring, int i) { return std::uint32_t(1 + (ring - 1) * around + i % around); };
  for (int i = 0; i < around; ++i) {
    result.triangles.emplace_back(top, at(1, i), at(1, i + 1));
    for (int ring = 1; ring + 1 < rings; ++ring) result.quad(at(ring, i), at(ring + 1, i), at(ring + 1, i + 1), at(ring, i + 1));
    result.triangles.emplace_back(bottom, at(rings - 1, i + 1), at(rings - 1, i));
  }
  return result;
}

/// A ring about z whose tube has the radius `tube`; the tube's center lies at `radius` - `tube`.
Triangles torus(float radius, float tube, int detail) {
  const int around = std::max(detail, 3), across = std::max(detail / 2, 3);
  Triangles result;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * j / across;
      const glm::vec3 out(std::cos(u), std::sin(u), 0);
      const glm::vec3 normal = float(std::cos(v)) * out + glm::vec3(0, 0, std::sin(v));
      result.add((radius - tube) * out + tube * normal, normal);
    }
  const auto at = [&](int i, int j) { return std::uint32_t(i % around * across + j % across); };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) result.quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  return result;
}

/// A rectangle from `corner`, cut in detail x detail cells.
void add_rectangle(Triangles& result, glm::vec3 corner, glm::vec3 right, glm::vec3 up, int detail) {
  const glm::vec3 normal = glm::normalize(glm::cross(right, up));
  const auto first = std::uint32_t(result.positions.size());
  for (int y = 0; y <= detail; ++y)
    for (int x = 0; x <= detail; ++x) result.add(corner + right * (float(x) / float(detail)) + up * (float(y) / float(detail)), normal);
  const auto at = [&](int x, int y) { return first + std::uint32_t(y * (detail + 1) + x); };
  for (int y = 0; y < detail; ++y)
    for (int x = 0; x < detail; ++x) result.quad(at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1));
}

Triangles box(float radius, int detail) {
  const glm::vec3 low(-radius), x(2 * radius, 0, 0), y(0, 2 * radius, 0), z(0, 0, 2 * radius);
  Triangles result;
  add_rectangle(result, low + z, x, y, detail);
  add_rectangle(result, low, y, x, detail);
  add_rectangle(result, low + x, y, z, detail);
  add_rectangle(result, low, z, y, detail);
  add_rectangle(result, low + y, z, x, detail);
  add_rectangle(result, low, x, z, detail);
  return result;
}

struct Shape : lumen::Importer {
  using Importer::Importer;

  lumen::Property<lumen::Choice> shape{this, "shape", {"sphere"}, {.doc = "the kind of surface", .choices = {"sphere", "torus", "box", "plane"}}};
  lumen::Property<float> radius{this, "radius", 1.0f, {.min = 1e-6, .max = 1e6, .unit = "world", .doc = "of the sphere, of the torus from its center outward; half the side of box and plane", .logarithmic = true}};
  lumen::Property<float> tube{this, "tube", 0.3f, {.min = 0.01, .max = 0.5, .unit = "radii", .doc = "radius of the torus's tube", .when = "shape = torus"}};
  lumen::Property<int> detail{this, "detail", 128, {.min = 1, .max = 1024, .doc = "cells around the sphere and the torus, or along a side; round shapes have at least 3", .logarithmic = true}};

  lumen::Output<lumen::Mesh> mesh{this, "mesh", {.doc = "the surface; box and plane face outward and +z"}};

  void compute(lumen::Job& job) const override {
    Triangles made;
    const std::string& name = job[shape].name;
    if (name == "sphere") made = sphere(job[radius], job[detail]);
    else if (name == "torus") made = torus(job[radius], job[tube] * job[radius], job[detail]);
    else if (name == "box") made = box(job[radius], job[detail]);
    else add_rectangle(made, {-job[radius], -job[radius], 0}, {2 * job[radius], 0, 0}, {0, 2 * job[radius], 0}, job[detail]);
    auto result = std::make_shared<lumen::Mesh>();
    result->origin = name;
    result->positions = std::move(made.positions);
    result->normals = std::move(made.normals);
    result->triangles = std::move(made.triangles);
    result->finish();
    job.set(mesh, result);
  }
};

}  // namespace

LUMEN_PLUGIN(Shape, "importer.shape", "a sphere, torus, box or plane with exact normals")
