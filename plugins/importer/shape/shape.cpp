/// Simple surfaces with exact normals: what techniques are tried on before real data.

#include <algorithm>
#include <array>
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

/// Three balls along z, of the radius, three quarters and half of it, on a tube, and welded to it: the ends of each tube are folds.
Triangles beads(float radius, float tube, int detail) {
  constexpr double gap = 1;  // between balls, in radii
  const std::array<double, 3> sizes = {1, 0.75, 0.5};
  const int around = std::max(detail, 3);
  const double thin = std::min(double(tube) / double(radius), 0.4), step = 2 * std::numbers::pi / around;
  struct Ring {
    double radius, z;
    glm::dvec2 normal;  // outward, along z
  };
  std::vector<Ring> rings;
  double z = -(sizes[0] + sizes[1] + sizes[2] + gap);
  const double top = -z;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const double size = sizes[i], fold = std::asin(thin / size), from = i == 0 ? 0 : fold, to = std::numbers::pi - (i + 1 < sizes.size() ? fold : 0);
    const int count = std::max(2, int(size * (to - from) / step));
    z += size;
    for (int k = i == 0 ? 1 : 0; k <= count - (i + 1 < sizes.size() ? 0 : 1); ++k) {
      const double angle = from + (to - from) * k / count;
      const glm::dvec2 out(std::sin(angle), -std::cos(angle));
      const bool folded = (i > 0 && k == 0) || k == count;
      rings.push_back({size * out.x, z + size * out.y, folded ? glm::normalize(out + glm::dvec2(1, 0)) : out});
    }
    z += size;
    if (i + 1 == sizes.size()) break;
    const double begin = rings.back().z, end = z + gap + sizes[i + 1] * (1 - std::cos(std::asin(thin / sizes[i + 1])));
    const int cells = std::max(1, int((end - begin) / step));
    for (int k = 1; k < cells; ++k) rings.push_back({thin, begin + (end - begin) * k / cells, {1, 0}});
    z += gap;
  }
  Triangles result;
  const std::uint32_t low = result.add({0, 0, -radius * float(top)}, {0, 0, -1});
  for (const Ring& ring : rings)
    for (int i = 0; i < around; ++i) {
      const glm::dvec2 out(std::cos(step * i), std::sin(step * i));
      result.add(double(radius) * glm::dvec3(ring.radius * out, ring.z), glm::dvec3(ring.normal.x * out, ring.normal.y));
    }
  const std::uint32_t high = result.add({0, 0, radius * float(top)}, {0, 0, 1});
  const int last = int(rings.size()) - 1;
  const auto at = [&](int ring, int i) { return std::uint32_t(1 + ring * around + i % around); };
  for (int i = 0; i < around; ++i) {
    result.triangles.emplace_back(low, at(0, i + 1), at(0, i));
    for (int ring = 0; ring < last; ++ring) result.quad(at(ring, i), at(ring, i + 1), at(ring + 1, i + 1), at(ring + 1, i));
    result.triangles.emplace_back(at(last, i), at(last, i + 1), high);
  }
  return result;
}

struct Shape : lumen::Importer {
  using Importer::Importer;

  lumen::Property<lumen::Choice> shape{this, "shape", {"sphere"}, {.doc = "the kind of surface", .choices = {"sphere", "torus", "box", "plane", "beads"}}};
  lumen::Property<float> radius{this, "radius", 1.0f, {.min = 1e-6, .max = 1e6, .unit = "world", .doc = "of the sphere and the largest bead, of the torus from its center outward; half the side of box and plane", .logarithmic = true}};
  lumen::Property<float> tube{this, "tube", 0.3f, {.min = 0.01, .max = 0.5, .unit = "radii", .doc = "radius of the torus's tube, or of that between beads (at most .4)"}};
  lumen::Property<int> detail{this, "detail", 128, {.min = 1, .max = 1024, .doc = "cells around sphere, torus and beads, or along a side; round shapes have at least 3", .logarithmic = true}};

  lumen::Output<lumen::Mesh> mesh{this, "mesh", {.doc = "the surface; box and plane face outward and +z"}};

  void compute(lumen::Job& job) const override {
    Triangles made;
    const std::string& name = job[shape].name;
    if (name == "sphere") made = sphere(job[radius], job[detail]);
    else if (name == "torus") made = torus(job[radius], job[tube] * job[radius], job[detail]);
    else if (name == "beads") made = beads(job[radius], job[tube] * job[radius], job[detail]);
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

LUMEN_PLUGIN(Shape, "importer.shape", "a sphere, torus, box, plane or string of beads with exact normals")
