#include "materials.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace {

using glm::vec3;

float step_between(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

// The eye looks along -z, as at any picture of a sphere.
float lit(const Place& at) { return std::max(0.0f, glm::dot(at.normal, at.to_light)); }
/// Light that goes around the edge, as in what is soft or translucent; 0 is Lambert's. Green, GPU Gems 2004, chapter 16.
float wrapped(const Place& at, float wrap) { return std::max(0.0f, (glm::dot(at.normal, at.to_light) + wrap) / (1 + wrap)); }
float rim(const Place& at, float exponent) { return std::pow(1 - std::clamp(at.normal.z, 0.0f, 1.0f), exponent); }
/// Blinn 1977.
float highlight(const Place& at, float exponent) { return std::pow(std::max(0.0f, glm::dot(at.normal, glm::normalize(at.to_light + vec3(0, 0, 1)))), exponent); }
/// Schlick 1994.
vec3 fresnel(const Place& at, vec3 facing) { return facing + (vec3(1) - facing) * rim(at, 5); }
vec3 mirrored_eye(const Place& at) { return 2 * at.normal.z * at.normal - vec3(0, 0, 1); }

/// A room for metals: bright above, dark below, a light where the light is. `sharpness` of the horizon and of the light.
vec3 room(const Place& at, vec3 direction, float sharpness) {
  const float height = step_between(-1 / sharpness, 1 / sharpness, direction.y);
  const vec3 below = glm::mix(vec3(0.05f, 0.045f, 0.04f), vec3(0.22f, 0.2f, 0.18f), std::clamp(1 + direction.y, 0.0f, 1.0f));
  const vec3 above = glm::mix(vec3(0.85f, 0.9f, 0.95f), vec3(0.2f, 0.3f, 0.45f), std::clamp(direction.y, 0.0f, 1.0f));
  const float lamp = std::pow(std::max(0.0f, glm::dot(direction, 2 * glm::dot(at.to_light, vec3(0, 0, 1)) * at.to_light - vec3(0, 0, 1))), 6 * sharpness);
  return glm::mix(below, above, height) + lamp * vec3(1.2f);
}

vec3 clay(const Place& at) { return vec3(0.42f, 0.17f, 0.10f) * (0.06f + 1.0f * wrapped(at, 0.05f)) + vec3(0.03f) * highlight(at, 8); }

vec3 skin(const Place& at) {
  // Red light travels farthest beneath the surface.
  const vec3 around(wrapped(at, 0.3f), wrapped(at, 0.1f), wrapped(at, 0.05f));
  return vec3(0.76f, 0.42f, 0.29f) * (vec3(0.05f, 0.03f, 0.025f) + 0.95f * around) + vec3(0.06f) * highlight(at, 18);
}

vec3 bone(const Place& at) { return vec3(0.78f, 0.69f, 0.51f) * (0.08f + 0.92f * wrapped(at, 0.1f)) + vec3(0.08f, 0.075f, 0.06f) * highlight(at, 30); }

vec3 artery(const Place& at) { return vec3(0.55f, 0.028f, 0.024f) * (0.08f + 0.95f * wrapped(at, 0.05f)) + vec3(0.75f, 0.6f, 0.55f) * highlight(at, 90); }

vec3 vein(const Place& at) { return vec3(0.05f, 0.08f, 0.38f) * (0.08f + 0.95f * wrapped(at, 0.05f)) + vec3(0.5f, 0.55f, 0.7f) * highlight(at, 70); }

vec3 jade(const Place& at) {
  const vec3 depth = glm::mix(vec3(0.004f, 0.035f, 0.018f), vec3(0.20f, 0.50f, 0.26f), wrapped(at, 0.25f));
  return depth + vec3(0.04f, 0.11f, 0.05f) * rim(at, 4) + vec3(0.9f) * highlight(at, 160);
}

vec3 porcelain(const Place& at) {
  return vec3(0.80f, 0.82f, 0.85f) * (0.10f + 0.84f * wrapped(at, 0.1f)) + fresnel(at, vec3(0.04f)) * 0.12f + vec3(0.8f) * highlight(at, 220);
}

vec3 gold(const Place& at) {
  return fresnel(at, vec3(1.0f, 0.71f, 0.29f)) * (room(at, mirrored_eye(at), 2.5f) * 0.75f + vec3(0.25f * lit(at)));
}

vec3 chrome(const Place& at) { return fresnel(at, vec3(0.55f, 0.556f, 0.554f)) * 1.5f * room(at, mirrored_eye(at), 16); }

vec3 toon(const Place& at) {
  constexpr vec3 base(0.72f, 0.16f, 0.12f);
  const float n = lit(at);
  const float level = 0.22f + 0.33f * step_between(0.29f, 0.31f, n) + 0.45f * step_between(0.69f, 0.71f, n);
  return base * level + (vec3(1) - base * level) * step_between(0.975f, 0.98f, highlight(at, 1));
}

vec3 x_ray(const Place& at) { return glm::mix(vec3(0.004f, 0.010f, 0.018f), vec3(0.75f, 0.92f, 1.0f), rim(at, 1.8f)); }

vec3 blueprint(const Place& at) {
  // Lines of height that keep their width on the sphere, and an outline.
  const float lines = 8, height = (1 - lit(at)) * lines, distance = std::abs(height - std::round(height));
  const float slope = lines * std::sqrt(std::max(1e-4f, 1 - lit(at) * lit(at)));
  const float line = 1 - step_between(0.010f * slope, 0.022f * slope, distance);
  const float outline = step_between(0.955f, 0.975f, std::sqrt(std::max(0.0f, 1 - at.normal.z * at.normal.z)));
  return glm::mix(vec3(0.012f, 0.06f, 0.22f) * (0.6f + 0.4f * lit(at)), vec3(0.70f, 0.82f, 0.95f), std::max(0.75f * line, outline));
}

vec3 soft_highlight(const Place& at) { return vec3(0.55f) * highlight(at, 60); }
vec3 sharp_highlight(const Place& at) { return vec3(1.0f) * step_between(0.990f, 0.993f, highlight(at, 1)); }

/// What a window with a cross mirrors in a glossy ball.
vec3 window_highlight(const Place& at) {
  const vec3 half = glm::normalize(at.to_light + vec3(0, 0, 1)), right = glm::normalize(glm::cross(vec3(0, 1, 0), half)), up = glm::cross(half, right);
  const glm::vec2 place(glm::dot(at.normal, right), glm::dot(at.normal, up));
  const glm::vec2 from_middle = glm::abs(place);
  const auto inside = [](float distance) { return 1 - step_between(0.27f, 0.29f, distance); };
  const auto off_bar = [](float distance) { return step_between(0.018f, 0.034f, distance); };
  if (glm::dot(at.normal, half) <= 0) return vec3(0);
  return vec3(0.9f, 0.93f, 1.0f) * inside(from_middle.x) * inside(from_middle.y) * off_bar(from_middle.x) * off_bar(from_middle.y) * (0.8f + 0.7f * place.y);
}

constexpr Material all[] = {
    {"clay", clay}, {"skin", skin}, {"bone", bone}, {"artery", artery}, {"vein", vein}, {"jade", jade}, {"porcelain", porcelain},
    {"gold", gold}, {"chrome", chrome}, {"toon", toon}, {"x-ray", x_ray}, {"blueprint", blueprint},
    {"soft highlight", soft_highlight}, {"sharp highlight", sharp_highlight}, {"window highlight", window_highlight}};

}  // namespace

std::span<const Material> materials() { return all; }

std::vector<std::string> material_names() {
  std::vector<std::string> names;
  for (const Material& material : materials()) names.emplace_back(material.name);
  return names;
}
