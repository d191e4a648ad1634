#include "highlights.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace {

constexpr int rounds = 16;
constexpr float no_length = 1e-6f;

/// A point that faces the camera.
struct Facing {
  glm::vec3 normal, to_eye;
  float weight;
};

struct Patch {
  glm::vec3 normal{0}, to_eye{0};   ///< weighted sums; the normal's direction is the patch's middle
  float weight = 0;
};

std::vector<Facing> facing(const CurvedPoints& points, const lumen::Camera& camera) {
  const glm::mat4 to_world = glm::inverse(camera.view);
  const glm::vec3 eye(to_world[3]), back(to_world[2]);
  std::vector<Facing> found;
  for (std::size_t i = 0; i < points.positions.size(); ++i) {
    const glm::vec3 arm = camera.orthographic ? back : eye - points.positions[i];
    const float length = glm::length(arm);
    if (points.weights[i] > 0 && length > no_length && glm::dot(points.normals[i], arm) > 0) found.push_back({points.normals[i], arm / length, points.weights[i]});
  }
  return found;
}

std::size_t nearest(const std::vector<glm::vec3>& middles, const glm::vec3& normal) {
  const auto farther = [&](const glm::vec3& a, const glm::vec3& b) { return glm::dot(a, normal) < glm::dot(b, normal); };
  return std::size_t(std::max_element(middles.begin(), middles.end(), farther) - middles.begin());
}

/// One after the other, where the surface bends most and is least alike to those before: the same in every run.
std::vector<glm::vec3> first_middles(const std::vector<Facing>& points, int count) {
  std::vector<float> unlike(points.size(), 1.0f);
  std::vector<glm::vec3> middles;
  while (int(middles.size()) < count) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
      if (points[i].weight * unlike[i] > points[best].weight * unlike[best]) best = i;
    if (!(points[best].weight * unlike[best] > 0)) break;
    middles.push_back(points[best].normal);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const float apart = 1 - glm::dot(points[i].normal, middles.back());
      unlike[i] = std::min(unlike[i], apart > no_length ? apart : 0.0f);
    }
  }
  return middles;
}

std::vector<Patch> patches_about(const std::vector<Facing>& points, const std::vector<glm::vec3>& middles) {
  std::vector<Patch> patches(middles.size());
  for (const Facing& point : points) {
    Patch& patch = patches[nearest(middles, point.normal)];
    patch.normal += point.weight * point.normal;
    patch.to_eye += point.weight * point.to_eye;
    patch.weight += point.weight;
  }
  std::erase_if(patches, [](const Patch& patch) { return glm::length(patch.normal) <= no_length * patch.weight; });
  return patches;
}

/// Where the light's mirror image is the eye's, or as near to that as the angle between both allows.
glm::vec3 toward_light(const Patch& patch, float widest) {
  const glm::vec3 to_eye = glm::normalize(patch.to_eye), mirrored = -glm::reflect(to_eye, glm::normalize(patch.normal));
  const float cosine = glm::dot(mirrored, to_eye);
  const glm::vec3 across = mirrored - cosine * to_eye;
  if (cosine >= std::cos(widest) || !(glm::length(across) > no_length)) return glm::normalize(mirrored);
  return std::cos(widest) * to_eye + std::sin(widest) * glm::normalize(across);
}

}  // namespace

CurvedPoints curved_points(const lumen::Mesh& mesh, const glm::mat4& object_to_world, std::size_t most) {
  CurvedPoints points;
  if (mesh.normals.empty()) return points;
  const lumen::Attribute* curvature = mesh.attribute("mean_curvature");
  if (curvature != nullptr && (curvature->on != lumen::Attribute::On::points || curvature->components != 1)) curvature = nullptr;
  const glm::mat3 turn = glm::transpose(glm::inverse(glm::mat3(object_to_world)));
  const std::size_t step = mesh.positions.size() / std::max<std::size_t>(most, 1) + 1;
  for (std::size_t i = 0; i < mesh.positions.size(); i += step) {
    const glm::vec3 normal = turn * mesh.normals[i];
    const float length = glm::length(normal), weight = curvature == nullptr ? 1.0f : std::abs(curvature->values[i]);
    if (!(length > 0) || !std::isfinite(length) || !std::isfinite(weight)) continue;
    points.positions.emplace_back(object_to_world * glm::vec4(mesh.positions[i], 1));
    points.normals.push_back(normal / length);
    points.weights.push_back(weight);
  }
  // Edges of the data bend without bound.
  std::vector<float> sorted = points.weights;
  if (sorted.empty()) return points;
  const auto limit = sorted.begin() + std::ptrdiff_t((sorted.size() - 1) * 99 / 100);
  std::nth_element(sorted.begin(), limit, sorted.end());
  for (float& weight : points.weights) weight = std::min(weight, *limit);
  return points;
}

std::vector<glm::vec3> highlight_directions(const CurvedPoints& points, const lumen::Camera& camera, int lights, float widest) {
  const std::vector<Facing> seen = facing(points, camera);
  if (seen.empty()) return {};
  std::vector<glm::vec3> middles = first_middles(seen, lights);
  std::vector<Patch> patches;
  for (int round = 0; round < rounds && !middles.empty(); ++round) {
    patches = patches_about(seen, middles);
    middles.clear();
    for (const Patch& patch : patches) middles.push_back(glm::normalize(patch.normal));
  }
  std::stable_sort(patches.begin(), patches.end(), [](const Patch& a, const Patch& b) { return a.weight > b.weight; });
  std::vector<glm::vec3> directions;
  for (const Patch& patch : patches) directions.push_back(toward_light(patch, widest));
  return directions;
}
