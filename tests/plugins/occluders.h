/// Scenes whose ambient occlusion has a closed form, made exactly: profiles drawn out along y, or turned about z. They face +z.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <lumen/mesh.h>
#include <lumen/testing.h>

namespace occluders {

constexpr float pi = std::numbers::pi_v<float>;

struct Builder {
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::uvec3> triangles;

  /// a b c d counterclockwise, seen from +z or from where the normals point.
  void quad(const glm::vec3 (&corners)[4], const glm::vec3 (&directions)[4]) {
    const auto first = std::uint32_t(positions.size());
    positions.insert(positions.end(), corners, corners + 4);
    normals.insert(normals.end(), directions, directions + 4);
    triangles.emplace_back(first, first + 1, first + 2);
    triangles.emplace_back(first, first + 2, first + 3);
  }
  std::shared_ptr<lumen::Mesh> mesh() {
    auto result = std::make_shared<lumen::Mesh>();
    result->positions = std::move(positions);
    result->normals = std::move(normals);
    result->triangles = std::move(triangles);
    result->origin = "occluders";
    result->finish();
    return result;
  }
};

/// Points (x, z) from left to right, y from -half_length to half_length.
inline std::shared_ptr<lumen::Mesh> drawn_out(const std::vector<glm::vec2>& profile, float half_length) {
  Builder builder;
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    const glm::vec2 a = profile[i], b = profile[i + 1], along = glm::normalize(b - a);
    const glm::vec3 normal(-along.y, 0, along.x);
    builder.quad({{a.x, -half_length, a.y}, {b.x, -half_length, b.y}, {b.x, half_length, b.y}, {a.x, half_length, a.y}}, {normal, normal, normal, normal});
  }
  return builder.mesh();
}

struct ProfilePoint {
  float r, z;
  glm::vec2 before, after;  ///< the normals (r, z) of the pieces that end and begin here
};

/// From the axis outward.
inline std::shared_ptr<lumen::Mesh> turned(const std::vector<ProfilePoint>& profile, int segments = 96) {
  Builder builder;
  for (std::size_t i = 0; i + 1 < profile.size(); ++i)
    for (int segment = 0; segment < segments; ++segment) {
      const auto at = [&](glm::vec2 point, int step) {
        const float angle = 2 * pi * float(step % segments) / float(segments);
        return glm::vec3(point.x * std::cos(angle), point.x * std::sin(angle), point.y);
      };
      const ProfilePoint &a = profile[i], &b = profile[i + 1];
      builder.quad({at({a.r, a.z}, segment), at({b.r, b.z}, segment), at({b.r, b.z}, segment + 1), at({a.r, a.z}, segment + 1)},
                   {at(a.after, segment), at(b.before, segment), at(b.before, segment + 1), at(a.after, segment + 1)});
    }
  return builder.mesh();
}

/// Two half planes that meet at `degrees` along x = 0, the bisector toward +z; they fill |x|, |y| <= 1.1.
inline std::shared_ptr<lumen::Mesh> crease(float degrees) {
  const float half = 0.5f * degrees * pi / 180, rise = 1.1f / std::tan(half);
  return drawn_out({{-1.1f, rise}, {0, 0}, {1.1f, rise}}, 1.1f);
}

/// A floor at z = 0 and, from x = 0 on, a step of this height.
inline std::shared_ptr<lumen::Mesh> wall(float height) { return drawn_out({{-1.1f, 0}, {0, 0}, {0, height}, {1.1f, height}}, 1.1f); }

inline std::shared_ptr<lumen::Mesh> trench(float half_width, float depth) {
  return drawn_out({{-1.1f, 0}, {-half_width, 0}, {-half_width, -depth}, {half_width, -depth}, {half_width, 0}, {1.1f, 0}}, 1.1f);
}

inline std::shared_ptr<lumen::Mesh> pit(float radius, float depth) {
  const glm::vec2 up(0, 1), in(-1, 0);
  return turned({{0, -depth, up, up}, {radius, -depth, up, in}, {radius, 0, in, up}, {1.5f, 0, up, up}});
}

/// A piece of a sphere, its rim in the plane z = 0, which goes on around it.
inline std::shared_ptr<lumen::Mesh> bowl(float radius, float depth) {
  std::vector<ProfilePoint> profile;
  const float widest = std::acos(1 - depth / radius);
  for (int ring = 0; ring <= 48; ++ring) {
    const float angle = widest * float(ring) / 48;
    const glm::vec2 normal(-std::sin(angle), std::cos(angle));
    profile.push_back({radius * std::sin(angle), radius * (1 - std::cos(angle)) - depth, normal, normal});
  }
  profile.back().after = {0, 1};
  profile.push_back({1.5f, 0, {0, 1}, {0, 1}});
  return turned(profile);
}

/// A tube along y, closed around, its axis at this height over the plane z = 0, which fills |x|, |y| <= 1.1.
inline std::shared_ptr<lumen::Mesh> tube_over_plane(float radius, float height) {
  Builder builder;
  const glm::vec3 up(0, 0, 1);
  builder.quad({{-1.1f, -1.1f, 0}, {1.1f, -1.1f, 0}, {1.1f, 1.1f, 0}, {-1.1f, 1.1f, 0}}, {up, up, up, up});
  constexpr int segments = 64;
  for (int segment = 0; segment < segments; ++segment) {
    const auto normal = [&](int step) {
      const float angle = 2 * pi * float(step % segments) / segments;
      return glm::vec3(std::sin(angle), 0, std::cos(angle));
    };
    const auto at = [&](int step, float y) { return normal(step) * radius + glm::vec3(0, y, height); };
    const glm::vec3 a = normal(segment), b = normal(segment + 1);
    builder.quad({at(segment, -1.1f), at(segment + 1, -1.1f), at(segment + 1, 1.1f), at(segment, 1.1f)}, {a, b, b, a});
  }
  return builder.mesh();
}

/// The mean over pixels x0..x1-1, y0..y1-1.
inline float mean(const lumen::testing::Pixels& layer, int x0, int y0, int x1, int y1) {
  double sum = 0;
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) sum += double(layer.at(x, y));
  return float(sum / double((x1 - x0) * (y1 - y0)));
}

/// The mean of a function of x over the centers of pixels x0..x1-1, in the world of lumen::testing::Scene.
inline float mean_of(const std::function<float(float)>& value, int x0, int x1, int width) {
  float sum = 0;
  for (int x = x0; x < x1; ++x) sum += value((float(x) + 0.5f - 0.5f * float(width)) * 2.2f / float(width));
  return sum / float(x1 - x0);
}

}  // namespace occluders
