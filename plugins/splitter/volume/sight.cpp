#include "sight.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

Sight::Sight(const lumen::Camera& camera, glm::ivec2 size, std::vector<float> depths)
    : camera_(camera), to_world_(glm::inverse(camera.view)), size_(size),
      pixel_((camera.orthographic ? camera.height : 2 * std::tan(glm::radians(camera.field_of_view) / 2)) / float(size.y)),
      depths_(std::move(depths)), number_(depths_.size(), -1) {
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const auto at = std::size_t(y) * std::size_t(size.x) + std::size_t(x);
      if (!std::isfinite(depths_[at])) continue;
      number_[at] = int(interest_.size());
      interest_.push_back(world(glm::vec2(x, y) + 0.5f, depths_[at]));
    }
}

glm::vec3 Sight::seen(glm::vec3 place) const {
  const glm::vec3 eye = camera_.view * glm::vec4(place, 1);
  return {0.5f * size_ + glm::vec2(eye) / (pixel_ * (camera_.orthographic ? 1.0f : -eye.z)), -eye.z};
}

glm::vec3 Sight::world(glm::vec2 pixel, float depth) const {
  const glm::vec2 plane = (pixel - 0.5f * size_) * pixel_ * (camera_.orthographic ? 1.0f : depth);
  return to_world_ * glm::vec4(plane, -depth, 1);
}

void Sight::add(const lumen::Mesh& mesh, const glm::mat4& object_to_world, std::span<const std::uint32_t> groups, float close) {
  std::vector<glm::vec3> corners;
  corners.reserve(mesh.positions.size());
  for (const glm::vec3& position : mesh.positions) corners.push_back(seen(object_to_world * glm::vec4(position, 1)));
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (!groups.empty() && groups[i] != 0) continue;
    const glm::vec3 &a = corners[mesh.triangles[i].x], &b = corners[mesh.triangles[i].y], &c = corners[mesh.triangles[i].z];
    if (!camera_.orthographic && std::min({a.z, b.z, c.z}) <= 0) continue;  // it reaches behind the eye
    const glm::vec2 low = glm::min(glm::vec2(a), glm::min(glm::vec2(b), glm::vec2(c))), high = glm::max(glm::vec2(a), glm::max(glm::vec2(b), glm::vec2(c)));
    const glm::ivec2 first(glm::ceil(glm::clamp(low - 0.5f, glm::vec2(0), size_))), last(glm::floor(glm::clamp(high - 0.5f, glm::vec2(-1), size_ - 1.0f)));
    const auto cross = [](glm::vec2 u, glm::vec2 v) { return u.x * v.y - u.y * v.x; };
    const float area = cross(glm::vec2(b - a), glm::vec2(c - a));
    if (area == 0) continue;
    for (int y = first.y; y <= last.y; ++y)
      for (int x = first.x; x <= last.x; ++x) {
        const auto at = std::size_t(y) * std::size_t(size_.x) + std::size_t(x);
        if (number_[at] < 0) continue;
        const glm::vec2 pixel = glm::vec2(x, y) + 0.5f;
        const float of_b = cross(pixel - glm::vec2(a), glm::vec2(c - a)) / area, of_c = cross(glm::vec2(b - a), pixel - glm::vec2(a)) / area, of_a = 1 - of_b - of_c;
        if (of_a < 0 || of_b < 0 || of_c < 0) continue;
        const float depth = camera_.orthographic ? of_a * a.z + of_b * b.z + of_c * c.z : 1 / (of_a / a.z + of_b / b.z + of_c / c.z);
        if (depth < depths_[at] - close) hiding_.push_back({number_[at], world(pixel, depth)});
      }
  }
}

float Sight::worth(const Cut& cut, float alpha, float beta, float whole) const {
  std::vector<char> covered(interest_.size(), 0);
  for (const Hiding& hiding : hiding_)
    if (!covered[std::size_t(hiding.pixel)] && !cut.holds(hiding.place)) covered[std::size_t(hiding.pixel)] = 1;
  const auto hidden = float(std::count(covered.begin(), covered.end(), 1)), all = float(covered.size());
  return (alpha * (all - hidden) - hidden) / all - beta * cut.volume() / whole;
}

Cut placed(const Sight& sight, const Cut& begin, bool move, bool scale, float alpha, float beta, float whole) {
  glm::vec3 low(1e30f), high(-1e30f);
  for (const Sight::Hiding& hiding : sight.hiding()) {
    low = glm::min(low, hiding.place);
    high = glm::max(high, hiding.place);
  }
  const float reach = std::max(0.5f * glm::length(high - low), 1e-20f);
  const glm::vec3 middle = 0.5f * (low + high);
  const auto worth = [&](const Cut& cut) { return sight.worth(cut, alpha, beta, whole); };
  Cut best = begin;
  float most = -1e30f;
  const auto consider = [&](const Cut& cut) {
    const float value = worth(cut);
    if (value <= most) return false;
    most = value;
    best = cut;
    return true;
  };
  // Its own size in units of the reach, so that factors mean the same for every shape.
  const float own = begin.shape == Cut::Shape::box ? 0.5f * glm::length(begin.size) : std::max(begin.radius, 1e-20f);
  std::vector<float> factors = {1};
  if (scale)
    for (factors.clear(); factors.size() < 12;) factors.push_back(reach / own * 0.25f * std::pow(1.25f, float(factors.size())));
  for (const float factor : factors) {
    Cut cut = begin.scaled(factor);
    if (move) cut.center = middle;
    consider(cut);
  }
  // Steps along the axes of the world and in size, halved where none is better.
  for (float step = 0.5f; step > 0.004f;) {
    bool better = false;
    const Cut here = best;
    for (int way = 0; way < 8; ++way) {
      const float side = way & 1 ? -1.0f : 1.0f;
      Cut cut = here;
      if (way < 6) cut.center[way / 2] += side * step * reach;
      else cut = here.scaled(1 + side * 0.5f * step);
      if (way < 6 ? move : scale) better = consider(cut) || better;
    }
    if (!better) step *= 0.5f;
  }
  return best;
}
