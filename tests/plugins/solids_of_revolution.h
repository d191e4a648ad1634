/// Solids turned about z, closed: balls on tubes, with known seams.
#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include <lumen/mesh.h>

namespace solids {

/// From its lowest point to its highest: (radius, z), the ends on the axis.
using Profile = std::vector<glm::dvec2>;

/// Appends a straight line to (radius, z), in steps of about `step`.
inline void line_to(Profile& profile, glm::dvec2 to, double step) {
  const glm::dvec2 from = profile.back();
  const int count = std::max(1, int(std::lround(glm::distance(from, to) / step)));
  for (int i = 1; i <= count; ++i) profile.push_back(glm::mix(from, to, double(i) / count));
}
/// Appends the arc of a ball about (0, z) between two angles from -z, without its first point.
inline void arc(Profile& profile, double radius, double z, double from, double to, double step) {
  const int count = std::max(1, int(std::lround(radius * (to - from) / step)));
  for (int i = 1; i <= count; ++i) {
    const double angle = from + (to - from) * i / count;
    profile.emplace_back(radius * std::sin(angle), z - radius * std::cos(angle));
  }
}

inline std::shared_ptr<lumen::Mesh> turned(const Profile& profile, int around) {
  auto mesh = std::make_shared<lumen::Mesh>();
  std::vector<glm::vec3> positions{{0, 0, profile.front().y}};
  std::vector<glm::uvec3> triangles;
  const auto rings = std::uint32_t(profile.size() - 2), count = std::uint32_t(around);
  for (std::uint32_t ring = 1; ring <= rings; ++ring)
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * std::numbers::pi * i / around;
      positions.emplace_back(profile[ring].x * std::cos(angle), profile[ring].x * std::sin(angle), profile[ring].y);
    }
  positions.emplace_back(0, 0, profile.back().y);
  const auto at = [&](std::uint32_t ring, std::uint32_t i) { return 1 + ring * count + i % count; };
  for (std::uint32_t i = 0; i < count; ++i) {
    triangles.emplace_back(0, at(0, i + 1), at(0, i));
    for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
      triangles.emplace_back(at(ring, i), at(ring, i + 1), at(ring + 1, i + 1));
      triangles.emplace_back(at(ring, i), at(ring + 1, i + 1), at(ring + 1, i));
    }
    triangles.emplace_back(at(rings - 1, i), at(rings - 1, i + 1), std::uint32_t(positions.size() - 1));
  }
  mesh->origin = "turned";
  mesh->positions = std::move(positions);
  mesh->triangles = std::move(triangles);
  mesh->finish();
  return mesh;
}

inline std::shared_ptr<lumen::Mesh> ball(double radius, int around = 48) {
  Profile profile{{0, -radius}};
  arc(profile, radius, 0, 0, std::numbers::pi, 2 * std::numbers::pi * radius / around);
  profile.back().x = 0;
  return turned(profile, around);
}

inline std::shared_ptr<lumen::Mesh> tube(double radius, double length, int around = 48) {
  const double step = 2 * std::numbers::pi * radius / around;
  Profile profile{{0, 0}};
  line_to(profile, {radius, 0}, step);
  line_to(profile, {radius, length}, step);
  line_to(profile, {0, length}, step);
  return turned(profile, around);
}

/// A ball of radius 1 about the origin; from it, a tube along +z up to `length`. They meet at z = sqrt(1 - radius^2).
inline std::shared_ptr<lumen::Mesh> ball_on_tube(double radius = 0.2, double length = 4, int around = 40) {
  Profile profile{{0, -1}};
  arc(profile, 1, 0, 0, std::numbers::pi - std::asin(radius), 0.06);
  line_to(profile, {radius, length}, 0.06);
  line_to(profile, {0, length}, 0.06);
  return turned(profile, around);
}

/// Balls of radius 1 about the origin and 0.7 about (0, 0, 4), joined by a tube.
inline std::shared_ptr<lumen::Mesh> dumbbell(double radius = 0.2, int around = 40) {
  Profile profile{{0, -1}};
  arc(profile, 1, 0, 0, std::numbers::pi - std::asin(radius), 0.06);
  line_to(profile, {radius, 4 - std::sqrt(0.49 - radius * radius)}, 0.06);
  arc(profile, 0.7, 4, std::asin(radius / 0.7), std::numbers::pi, 0.06);
  profile.back().x = 0;
  return turned(profile, around);
}

}  // namespace solids
