/// Rays through the solid from a sample of the triangles; each other triangle follows the sample that is fewest steps away.
#include "thickness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <rays/ray_triangles.h>

namespace {

constexpr std::uint32_t none = lumen::Neighbor::none;

/// A direction, its angle to +z given by the cosine, and how much it counts.
struct ConeRay {
  glm::vec3 direction;
  float weight;
};

/// Spread evenly over the cone about +z by the golden angle. As the paper has it, a ray counts by the inverse of its angle.
std::vector<ConeRay> cone_rays(const ThicknessOptions& options) {
  const float lowest = std::cos(0.5f * glm::radians(options.cone)), golden = std::numbers::pi_v<float> * (3 - std::sqrt(5.0f));
  std::vector<ConeRay> rays;
  for (int i = 0; i < options.rays; ++i) {
    const float z = 1 - (1 - lowest) * (float(i) + 0.5f) / float(options.rays), out = std::sqrt(1 - z * z), around = golden * float(i);
    rays.push_back({{out * std::cos(around), out * std::sin(around), z}, 1 / std::acos(z)});
  }
  return rays;
}

class Probe {
 public:
  Probe(const Surface& surface, const ThicknessOptions& options) : surface_(surface), rays_(cone_rays(options)) {
    const auto room = triangles_.add(surface.positions().size(), surface.size());
    std::copy(surface.positions().begin(), surface.positions().end(), room.positions.begin());
    for (std::size_t i = 0; i < surface.size(); ++i) room.triangles[i] = surface.corners(i);
    triangles_.build();
  }

  /// The logarithm; nothing if no ray finds another side.
  std::optional<float> logarithm(std::size_t triangle) {
    const glm::vec3 inward = -surface_.smooth_normal(triangle), face = surface_.normal(triangle);
    if (!(glm::dot(inward, face) < 0)) return std::nullopt;
    const glm::vec3 tangent = glm::normalize(std::abs(inward.z) > 0.5f ? glm::vec3(inward.z, 0, -inward.x) : glm::vec3(-inward.y, inward.x, 0));
    const glm::vec3 bitangent = glm::cross(inward, tangent), origin = surface_.center(triangle);
    found_.clear();
    for (const ConeRay& ray : rays_) {
      const glm::vec3 direction = ray.direction.x * tangent + ray.direction.y * bitangent + ray.direction.z * inward;
      if (!(glm::dot(direction, face) < 0)) continue;
      const float least = 1e-5f * std::max({std::abs(origin.x), std::abs(origin.y), std::abs(origin.z)});
      const auto hit = triangles_.first(origin, direction, least, std::numeric_limits<float>::infinity());
      // What faces the ray is the outside of something: the surface crosses itself or is open here.
      if (hit && hit->triangle != triangle && glm::dot(hit->normal, direction) > 0) found_.push_back({std::log(hit->distance / ray.direction.z), ray.weight});
    }
    return found_.empty() ? std::nullopt : std::optional(typical());
  }

 private:
  struct Found {
    float value, weight;
  };

  /// The weighted mean of what lies within one standard deviation of the median.
  float typical() {
    std::sort(found_.begin(), found_.end(), [](const Found& a, const Found& b) { return a.value < b.value; });
    const float median = 0.5f * (found_[(found_.size() - 1) / 2].value + found_[found_.size() / 2].value);
    float square = 0;
    for (const Found& found : found_) square += (found.value - median) * (found.value - median);
    const float deviation = std::sqrt(square / float(found_.size())) + 1e-6f;
    float sum = 0, weight = 0;
    for (const Found& found : found_)
      if (std::abs(found.value - median) <= deviation) sum += found.weight * found.value, weight += found.weight;
    return weight > 0 ? sum / weight : median;
  }

  const Surface& surface_;
  std::vector<ConeRay> rays_;
  lumen::RayTriangles triangles_;
  std::vector<Found> found_;
};

/// Samples, and of each triangle the sample that it follows, or none.
struct Sampling {
  std::vector<float> logarithms;
  std::vector<std::uint32_t> of_triangle;
};

Sampling sampled(const Surface& surface, const ThicknessOptions& options, const std::function<void(float)>& progress) {
  Probe probe(surface, options);
  Sampling sampling{.logarithms = {}, .of_triangle = std::vector<std::uint32_t>(surface.size(), none)};
  std::vector<std::uint32_t> reached;
  const auto sample = [&](std::uint32_t triangle) {
    const auto logarithm = probe.logarithm(triangle);
    if (!logarithm) return false;
    sampling.of_triangle[triangle] = std::uint32_t(sampling.logarithms.size());
    sampling.logarithms.push_back(*logarithm);
    reached.push_back(triangle);
    return true;
  };
  std::size_t next = 0;
  const auto spread = [&] {
    for (; next < reached.size(); ++next)
      for (const lumen::Neighbor& neighbor : surface.neighbors(reached[next])) {
        if (neighbor.triangle == none || sampling.of_triangle[neighbor.triangle] != none) continue;
        sampling.of_triangle[neighbor.triangle] = sampling.of_triangle[reached[next]];
        reached.push_back(neighbor.triangle);
      }
  };
  // One sample each time that so much area has passed; small meshes sample all triangles.
  const bool all = surface.size() <= options.samples;
  const double step = surface.area() / double(options.samples);
  double passed = 0.5 * step;
  for (std::uint32_t triangle = 0; triangle < surface.size(); ++triangle) {
    if (triangle % 4096 == 0) progress(float(triangle) / float(surface.size()));
    passed += surface.area(triangle);
    if (!all && passed < step) continue;
    passed = std::fmod(passed, step);
    sample(triangle);
  }
  spread();
  // What is connected to no sample has one of its own.
  for (std::uint32_t triangle = 0; triangle < surface.size(); ++triangle)
    if (sampling.of_triangle[triangle] == none && sample(triangle)) spread();
  return sampling;
}

/// Two samples side by side, along a border of such a length.
struct Contact {
  std::uint32_t a, b;
  float length;
};

std::vector<Contact> contacts_of(const Surface& surface, const std::vector<std::uint32_t>& of_triangle) {
  std::vector<Contact> contacts;
  for (std::uint32_t i = 0; i < surface.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t other = surface.neighbors(i)[std::size_t(k)].triangle;
      if (other == none || other < i || of_triangle[i] == of_triangle[other] || of_triangle[i] == none || of_triangle[other] == none) continue;
      contacts.push_back({of_triangle[i], of_triangle[other], surface.edge_length(i, k)});
    }
  return contacts;
}

/// Neighbors count by the length of their border, and less the more they differ: steps of thickness stay.
void smooth(std::vector<float>& values, const std::vector<Contact>& contacts, int rounds) {
  constexpr float alike = 0.35f;  // of logarithms
  std::vector<float> sum(values.size()), weight(values.size()), around(values.size(), 0.0f);
  for (const Contact& contact : contacts) around[contact.a] += contact.length, around[contact.b] += contact.length;
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < values.size(); ++i) weight[i] = 0.5f * around[i] + 1e-30f, sum[i] = weight[i] * values[i];
    for (const auto& [a, b, length] : contacts) {
      const float apart = (values[a] - values[b]) / alike, shared = length / (1 + apart * apart);
      sum[a] += shared * values[b], weight[a] += shared;
      sum[b] += shared * values[a], weight[b] += shared;
    }
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = sum[i] / weight[i];
  }
}

}  // namespace

std::vector<float> thickness_of(const Surface& surface, const ThicknessOptions& options, const std::function<void(float)>& progress) {
  Sampling sampling = sampled(surface, options, progress);
  smooth(sampling.logarithms, contacts_of(surface, sampling.of_triangle), options.smoothing);
  std::vector<float> thickness(surface.size(), 0.0f);
  for (std::size_t i = 0; i < surface.size(); ++i)
    if (sampling.of_triangle[i] != none) thickness[i] = std::exp(sampling.logarithms[sampling.of_triangle[i]]);
  progress(1);
  return thickness;
}
