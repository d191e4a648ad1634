/// A grid along and across, less the cells of the tears, whose rims are moved onto ellipses; then top, bottom and rim.
#include "flap.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

Flap::Flap(const Anatomy& anatomy, const FlapOptions& options) : anatomy_(anatomy), options_(options) {
  const Dissection& dissection = anatomy.dissection();
  const float length = dissection.end() - dissection.begin();
  // Where the split is narrower than that, the membrane lies at the wall.
  begin_ = dissection.begin() + 0.06f * length;
  end_ = dissection.end() - 0.08f * length;
  constexpr int probes = 32;
  mean_half_width_ = 0;
  for (int probe = 0; probe < probes; ++probe) mean_half_width_ += half_width(begin_ + (end_ - begin_) * (static_cast<float>(probe) + 0.5f) / probes) / probes;

  const float slab = end_ - begin_;
  const auto add_hole = [&](float share, float across, float hole_length) {
    const float width = half_width(begin_ + share * slab);
    const glm::vec2 radii(std::min(0.5f * hole_length, 0.1f * slab), std::min(0.3f * hole_length, 0.45f * width));
    if (radii.x > 0.5f && radii.y > 0.5f) holes_.push_back({{share * slab, across * width}, radii});
  };
  if (options.tear > 0) {
    add_hole(0.16f, 0.05f, options.tear);
    add_hole(0.82f, -0.1f, 0.55f * options.tear);
  }
}

float Flap::half_width(float distance) const {
  const float offset = anatomy_.dissection().membrane(distance);
  const float inner = anatomy_.dissection().inner_radius(anatomy_.aorta().at(distance));
  // Its edges end within the wall.
  return inner * 1.04f * std::sqrt(std::max(0.02f, 1 - offset * offset));
}

Flap::Point Flap::point(float distance, float across) const {
  const Dissection& dissection = anatomy_.dissection();
  const CurveFrame frame = anatomy_.aorta().at(distance);
  const glm::vec2 toward = dissection.direction(distance);
  const glm::vec3 up = toward.x * frame.right + toward.y * frame.up;
  const glm::vec3 side = -toward.y * frame.right + toward.x * frame.up;
  const float inner = dissection.inner_radius(frame), opening = dissection.opening(distance);
  // It sags into the false lumen, and flutters.
  const float sag = opening * (1 - across * across) * inner * (0.06f + 0.05f * std::sin(0.16f * distance + 1.7f * across));
  const float height = dissection.membrane(distance) * inner + sag + 0.04f * frame.radius * opening;
  const glm::vec3 offset = height * up + across * half_width(distance) * side;
  return {frame.position + offset, up, glm::length(offset)};
}

std::size_t Flap::estimate(float edge) const {
  const float cells = (end_ - begin_) * 2 * mean_half_width_ / (edge * edge);
  return static_cast<std::size_t>(4 * cells + 4 * ((end_ - begin_) + 2 * mean_half_width_) / edge);
}

void Flap::add(Shell& shell, float edge, const Progress& progress) const {
  const int along = std::max(6, static_cast<int>(std::lround((end_ - begin_) / edge)));
  const int across = std::max(4, static_cast<int>(std::lround(2 * mean_half_width_ / edge)));
  const auto distance_of = [&](float i) { return begin_ + (end_ - begin_) * i / static_cast<float>(along); };
  const auto across_of = [&](float j) { return 2 * j / static_cast<float>(across) - 1; };
  // In millimeters of the flattened slab, where the tears are ellipses.
  const auto flat = [&](float i, float j) { return glm::vec2(distance_of(i) - begin_, across_of(j) * mean_half_width_); };
  const auto hole_at = [&](glm::vec2 place) -> const Hole* {
    for (const Hole& hole : holes_)
      if (const glm::vec2 offset = (place - hole.center) / hole.radii; glm::dot(offset, offset) < 1) return &hole;
    return nullptr;
  };
  const auto inside = [&](int i, int j) { return i >= 0 && j >= 0 && i < along && j < across; };
  std::vector<const Hole*> removed(static_cast<std::size_t>(along) * static_cast<std::size_t>(across));
  const auto cell = [&](int i, int j) -> const Hole*& { return removed[static_cast<std::size_t>(i) * static_cast<std::size_t>(across) + static_cast<std::size_t>(j)]; };
  for (int i = 0; i < along; ++i)
    for (int j = 0; j < across; ++j) {
      const bool near_the_rim = i < 2 || j < 1 || i + 2 >= along || j + 1 >= across;
      cell(i, j) = near_the_rim ? nullptr : hole_at(flat(static_cast<float>(i) + 0.5f, static_cast<float>(j) + 0.5f));
    }
  const auto kept = [&](int i, int j) { return inside(i, j) && !cell(i, j); };

  const auto base = static_cast<std::uint32_t>(shell.positions.size());
  const auto first_triangle = shell.triangles.size();
  constexpr std::uint32_t none = ~0u;
  std::vector<std::uint32_t> top(static_cast<std::size_t>(along + 1) * static_cast<std::size_t>(across + 1), none);
  const auto index_of = [&](int i, int j) { return static_cast<std::size_t>(i) * static_cast<std::size_t>(across + 1) + static_cast<std::size_t>(j); };
  for (int i = 0; i <= along; ++i) {
    if (i % 32 == 0) progress(static_cast<float>(i) / static_cast<float>(along));
    for (int j = 0; j <= across; ++j) {
      const Hole* hole = nullptr;
      bool used = false;
      for (int corner = 0; corner < 4; ++corner) {
        const int ci = i - corner % 2, cj = j - corner / 2;
        used = used || kept(ci, cj);
        if (inside(ci, cj) && cell(ci, cj)) hole = cell(ci, cj);
      }
      if (!used) continue;
      glm::vec2 place = flat(static_cast<float>(i), static_cast<float>(j));
      if (hole) {
        const glm::vec2 offset = (place - hole->center) / hole->radii;
        place = hole->center + hole->radii * offset / std::max(glm::length(offset), 0.1f);
      }
      const Point middle = point(begin_ + place.x, place.y / mean_half_width_);
      const float pressure = 110 - 24 * place.x / (end_ - begin_);
      const glm::vec3 half = 0.5f * options_.thickness * middle.normal;
      top[index_of(i, j)] = shell.add(middle.position + half, middle.radius, pressure);
      shell.add(middle.position - half, middle.radius, pressure - 4);  // the bottom's number is the top's plus one
    }
  }

  const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    shell.triangles.emplace_back(a, b, c);
    shell.triangles.emplace_back(a, c, d);
  };
  for (int i = 0; i < along; ++i)
    for (int j = 0; j < across; ++j) {
      if (!kept(i, j)) continue;
      // along x across: forward x side = -toward the false lumen, so the top runs across first.
      const std::uint32_t a = top[index_of(i, j)], b = top[index_of(i, j + 1)], c = top[index_of(i + 1, j + 1)], d = top[index_of(i + 1, j)];
      quad(a, b, c, d);
      quad(a + 1, d + 1, c + 1, b + 1);
      if (!kept(i, j - 1)) quad(d, d + 1, a + 1, a);
      if (!kept(i + 1, j)) quad(c, c + 1, d + 1, d);
      if (!kept(i, j + 1)) quad(b, b + 1, c + 1, c);
      if (!kept(i - 1, j)) quad(a, a + 1, b + 1, b);
    }

  std::vector<glm::uvec3> own(shell.triangles.begin() + static_cast<std::ptrdiff_t>(first_triangle), shell.triangles.end());
  for (glm::uvec3& triangle : own) triangle -= base;
  const std::span<const glm::vec3> positions(shell.positions.data() + base, shell.positions.size() - base);
  const std::vector<glm::vec3> normals = lumen::average_normals(positions, own);
  std::copy(normals.begin(), normals.end(), shell.normals.begin() + base);
}
