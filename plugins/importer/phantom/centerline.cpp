/// Sampling of the spline, and rotation-minimizing frames by double reflection (Wang et al., TOG 2008).
#include "centerline.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace {

constexpr int sample_count = 4096;

/// The uniform cubic B-spline; controls mirrored beyond the ends make it reach them. `t` in 0..controls - 1.
glm::vec4 spline(std::span<const glm::vec4> controls, float t) {
  const int last = static_cast<int>(controls.size()) - 1;
  const int span = std::clamp(static_cast<int>(t), 0, last - 1);
  const float f = t - static_cast<float>(span), g = 1 - f;
  const auto control = [&](int index) {
    if (index < 0) return 2.0f * controls[0] - controls[1];
    if (index > last) return 2.0f * controls[static_cast<std::size_t>(last)] - controls[static_cast<std::size_t>(last - 1)];
    return controls[static_cast<std::size_t>(index)];
  };
  const float a = g * g * g / 6, b = (3 * f * f * f - 6 * f * f + 4) / 6, c = (3 * g * g * g - 6 * g * g + 4) / 6, d = f * f * f / 6;
  return a * control(span - 1) + b * control(span) + c * control(span + 1) + d * control(span + 2);
}

}  // namespace

Centerline::Centerline(std::span<const glm::vec4> controls) : samples_(sample_count), distance_(sample_count), controls_(controls.size()) {
  const float last = static_cast<float>(controls.size() - 1);
  for (int index = 0; index < sample_count; ++index) {
    const glm::vec4 point = spline(controls, last * static_cast<float>(index) / (sample_count - 1));
    samples_[index].position = point;
    samples_[index].radius = point.w;
  }
  for (int index = 1; index < sample_count; ++index)
    distance_[index] = distance_[index - 1] + glm::distance(samples_[index].position, samples_[index - 1].position);
  for (int index = 0; index < sample_count; ++index) {
    const int before = std::max(index - 1, 0), after = std::min(index + 1, sample_count - 1);
    samples_[index].forward = glm::normalize(samples_[after].position - samples_[before].position);
  }

  const glm::vec3 axis = std::abs(samples_[0].forward.x) < 0.7f ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1);
  samples_[0].right = glm::normalize(axis - glm::dot(axis, samples_[0].forward) * samples_[0].forward);
  for (int index = 1; index < sample_count; ++index) {
    const CurveFrame& previous = samples_[index - 1];
    const glm::vec3 step = samples_[index].position - previous.position;
    const float square = glm::dot(step, step);
    glm::vec3 right = previous.right, forward = previous.forward;
    if (square > 0) {
      right -= 2 / square * glm::dot(step, right) * step;
      forward -= 2 / square * glm::dot(step, forward) * step;
    }
    const glm::vec3 mirror = samples_[index].forward - forward;
    if (const float size = glm::dot(mirror, mirror); size > 1e-12f) right -= 2 / size * glm::dot(mirror, right) * mirror;
    samples_[index].right = glm::normalize(right - glm::dot(right, samples_[index].forward) * samples_[index].forward);
  }
  for (CurveFrame& sample : samples_) sample.up = glm::cross(sample.forward, sample.right);
}

CurveFrame Centerline::at(float distance) const {
  const auto after = std::clamp(std::upper_bound(distance_.begin(), distance_.end(), distance) - distance_.begin(), std::ptrdiff_t{1}, std::ptrdiff_t{sample_count - 1});
  const CurveFrame &a = samples_[after - 1], &b = samples_[after];
  const float width = distance_[after] - distance_[after - 1];
  const float t = width > 0 ? std::clamp((distance - distance_[after - 1]) / width, 0.0f, 1.0f) : 0.0f;
  CurveFrame frame;
  frame.position = glm::mix(a.position, b.position, t);
  frame.radius = glm::mix(a.radius, b.radius, t);
  frame.forward = glm::normalize(glm::mix(a.forward, b.forward, t));
  frame.right = glm::mix(a.right, b.right, t);
  frame.right = glm::normalize(frame.right - glm::dot(frame.right, frame.forward) * frame.forward);
  frame.up = glm::cross(frame.forward, frame.right);
  return frame;
}

float Centerline::distance_at(float control) const {
  const float sample = control / static_cast<float>(controls_ - 1) * (sample_count - 1);
  return distance_[static_cast<std::size_t>(std::clamp(sample, 0.0f, static_cast<float>(sample_count - 1)))];
}
