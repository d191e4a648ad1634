#include "coverage.h"

#include <algorithm>
#include <cmath>

namespace {

/// Pixels: a rasterizer that has 8 bits below the pixel moves corners by up to 1/512; some room for rounding.
constexpr float snapping = 1.0f / 128;
/// Of a chain of matrix products in single precision, relative.
constexpr float product_error = 1.0f / (1 << 20);
/// Where more centers than this lie in a triangle's box, one is most likely covered.
constexpr int most_centers = 4;

// Of three in registers: a list would go through memory.
float least(float a, float b, float c) { return std::min(a, std::min(b, c)); }
float greatest(float a, float b, float c) { return std::max(a, std::max(b, c)); }

}  // namespace

Coverage::Coverage(const glm::mat4& world_to_clip, const glm::mat4& object_to_world, glm::ivec2 size, float reach) : size_(size) {
  const auto pixels_of = [&](const glm::mat4& matrix, int axis) {
    const glm::mat4 rows = glm::transpose(matrix);
    return 0.5f * size_[axis] * (rows[axis] + rows[3]);
  };
  const glm::mat4 object_to_clip = world_to_clip * object_to_world;
  row_x_ = pixels_of(object_to_clip, 0);
  row_y_ = pixels_of(object_to_clip, 1);
  row_w_ = glm::transpose(object_to_clip)[3];
  rounding_ = product_error * reach * std::max(glm::length(glm::vec3(pixels_of(world_to_clip, 0))), glm::length(glm::vec3(pixels_of(world_to_clip, 1))));
}

bool Coverage::may_cover(const Place& a, const Place& b, const Place& c, bool backs) const {
  // Behind the eye or beside it, a projection says nothing. The comparison is false for what is not a number, too.
  if (!(least(a.inverse_w, b.inverse_w, c.inverse_w) > 0)) return true;
  const float slack = snapping + rounding_ * greatest(a.inverse_w, b.inverse_w, c.inverse_w);
  // Centers are at halves: numbers of the first one from `low` on, and of the first one beyond `high`.
  const auto first_from = [](float place, float size) { return int(std::min(size, std::max(0.0f, place)) + 0.5f); };
  const int left = first_from(least(a.x, b.x, c.x) - slack, size_.x), right = first_from(greatest(a.x, b.x, c.x) + slack, size_.x);
  const int bottom = first_from(least(a.y, b.y, c.y) - slack, size_.y), top = first_from(greatest(a.y, b.y, c.y) + slack, size_.y);
  if (left >= right || bottom >= top) return false;

  const float bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
  const float area = bx * cy - by * cx, lengths = std::abs(bx) + std::abs(by) + std::abs(cx) + std::abs(cy);
  const float unsure = 2 * slack * (lengths + 2 * slack);  // of areas, when each corner moves by the slack
  if (std::abs(area) <= unsure) return true;
  if (area < 0 && !backs) return false;
  if ((right - left) * (top - bottom) > most_centers) return true;
  const float sign = area < 0 ? -1.0f : 1.0f;
  for (int row = bottom; row < top; ++row)
    for (int column = left; column < right; ++column) {
      const float px = float(column) + 0.5f - a.x, py = float(row) + 0.5f - a.y;
      const float ab = sign * (bx * py - by * px), ca = sign * (cy * px - cx * py), bc = sign * area - ab - ca;
      if (least(ab, ca, bc) >= -unsure) return true;
    }
  return false;
}

void Coverage::gather(const Cluster& cluster, bool backs, const glm::vec3* positions, const glm::uvec3* triangles, std::vector<glm::uvec3>& kept) {
  places_.resize(cluster.points);
  for (std::uint32_t i = 0; i < cluster.points; ++i) places_[i] = place_of(positions[cluster.first_point + i]);
  const auto place = [&](std::uint32_t point) {
    const std::uint32_t own = point - cluster.first_point;
    return own < cluster.points ? places_[own] : place_of(positions[point]);
  };
  std::size_t end = kept.size();
  kept.resize(end + cluster.count);
  for (std::uint32_t i = cluster.first; i < cluster.first + cluster.count; ++i) {
    const glm::uvec3& triangle = triangles[i];
    kept[end] = triangle;
    end += may_cover(place(triangle.x), place(triangle.y), place(triangle.z), backs) ? 1 : 0;
  }
  kept.resize(end);
}
