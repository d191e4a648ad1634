#include "forces.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace {

constexpr std::size_t most_points = 8;
constexpr float nearest = 0.05f;
/// Of the iteration, in radii: what a step makes of a force at rest, how far the return force's slope is followed, the longest step, and when
/// all is in equilibrium.
constexpr float stride = 0.5f, inertia = 0.6f, farthest = 2, longest = 0.3f, in_equilibrium = 1e-4f;
constexpr int most_steps = 60;

constexpr float no_direction = 1e-4f;

/// Unit; `otherwise` if there is no direction.
glm::vec3 direction(const glm::vec3& r, const glm::vec3& otherwise) {
  const float length = glm::length(r);
  return length > no_direction ? r / length : otherwise;
}

/// Points spread through parts as the paper's are through voxels: of triangles that lie far from one another, each next one the farthest from
/// those before (Gonzalez 1985), drawn toward their part's center so that they fill a ball evenly.
std::vector<glm::vec3> spread_points(const Pieces& pieces, const std::vector<int>& of) {
  struct Place {
    glm::vec3 at, center;
  };
  std::vector<Place> places;
  for (const int part : of) {
    const Piece& piece = pieces.list[std::size_t(part)];
    for (const Corners& triangle : piece.triangles) places.push_back({(triangle[0] + triangle[1] + triangle[2]) / 3.0f, piece.center});
  }
  std::vector<glm::vec3> chosen;
  std::vector<float> distance(places.size(), std::numeric_limits<float>::infinity());
  for (std::size_t next = 0; next < places.size() && chosen.size() < most_points && distance[next] > 0;) {
    const Place place = places[next];
    chosen.push_back(glm::mix(place.center, place.at, std::cbrt((float(chosen.size()) + 0.5f) / float(most_points))));
    for (std::size_t i = 0; i < places.size(); ++i) distance[i] = std::min(distance[i], glm::distance(places[i].at, place.at));
    next = std::size_t(std::max_element(distance.begin(), distance.end()) - distance.begin());
  }
  return chosen;
}

}  // namespace

ForceLayout::ForceLayout(const Pieces& pieces, std::vector<int> fixed) : fixed_(std::move(fixed)), center_(pieces.center), radius_(std::max(pieces.radius, 1e-30f)) {
  const auto inside = [&](const glm::vec3& world) { return (world - center_) / radius_; };
  for (const Piece& piece : pieces.list) {
    const auto index = float(blocks_.size());
    // Directions on a spiral from pole to pole: no two parts share theirs.
    const float height = 1 - 2 * (index + 0.5f) / float(pieces.list.size()), angle = 2.39996323f * index, width = std::sqrt(std::max(0.0f, 1 - height * height));
    blocks_.push_back({.center = inside(piece.center), .low = inside(piece.bounds.min), .high = inside(piece.bounds.max), .radius = piece.bounds.radius() / radius_,
                       .aside = {width * std::cos(angle), width * std::sin(angle), height}});
  }
  for (std::size_t i = 0; i < blocks_.size() && fixed_.empty(); ++i) blocks_[i].ease = 1 - pieces.list[i].share;
  for (const int part : fixed_) blocks_[std::size_t(part)].ease = 0;
  for (const glm::vec3& point : spread_points(pieces, fixed_)) points_.push_back(inside(point));
  if (points_.empty()) points_ = {glm::vec3(0)};
}

glm::vec3 ForceLayout::force(std::size_t part, std::span<const glm::vec3> moves, float degree, const Strengths& strengths, std::span<const glm::vec3> rays) const {
  const Block& block = blocks_[part];
  const glm::vec3 move = moves[part], center = block.center + move;
  const float far = glm::length(move);
  const glm::vec3 back = far > 0 ? -strengths.back * std::log1p(far) / far * move : glm::vec3(0);

  glm::vec3 explosion(0), viewing(0), spacing(0);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const glm::vec3 &point = points_[i], away = center - point, gap = glm::clamp(point, block.low + move, block.high + move) - point;
    const float distance = glm::length(gap);
    explosion += std::exp(-distance) * (distance > no_direction ? gap / distance : direction(away, block.aside));
    if (rays.empty()) continue;
    const glm::vec3& toward_eye = rays[i];
    const float along = glm::dot(away, toward_eye), before = std::clamp(0.5f + 0.5f * along / std::max(block.radius, nearest), 0.0f, 1.0f);
    const glm::vec3 across = away - along * toward_eye;
    const float aside = glm::length(across);
    if (aside > no_direction) viewing += before / (std::max(aside, nearest) * aside) * across;
    else viewing += before / nearest * direction(block.aside - glm::dot(block.aside, toward_eye) * toward_eye, glm::vec3(0));
  }
  for (std::size_t other = 0; other < blocks_.size(); ++other) {
    if (other == part) continue;
    const glm::vec3 r = center - blocks_[other].center - moves[other];
    const float square = std::max(glm::dot(r, r), nearest * nearest);
    spacing += direction(r, block.aside) / square;
  }
  const float points = float(points_.size()), others = float(blocks_.size());
  return back + degree * (strengths.explosion / points * explosion + strengths.viewing / points * viewing + strengths.spacing / others * spacing);
}

std::vector<glm::vec3> ForceLayout::moves(std::span<const float> degrees, const Strengths& strengths, const lumen::Camera& camera) const {
  std::vector<glm::vec3> moves(blocks_.size(), glm::vec3(0)), forces(blocks_.size(), glm::vec3(0)), rays;
  const glm::mat4 to_world = glm::inverse(camera.view);
  if (views(strengths))
    for (const glm::vec3& point : points_)
      rays.push_back(glm::normalize(camera.orthographic ? glm::vec3(to_world[2]) : (glm::vec3(to_world[3]) - center_) / radius_ - point));
  const bool any = std::any_of(degrees.begin(), degrees.end(), [](float degree) { return degree > 0; });
  std::vector<glm::vec3> steps(blocks_.size(), glm::vec3(0));
  for (int step = 0; any && step < most_steps; ++step) {
    for (std::size_t part = 0; part < blocks_.size(); ++part)
      if (const float degree = degrees[part] * blocks_[part].ease; degree > 0) forces[part] = force(part, moves, degree, strengths, rays);
    float moved = 0;
    for (std::size_t part = 0; part < blocks_.size(); ++part) {
      // Some of the step before is kept, unless that went too far (O'Donoghue, Candes, Adaptive Restart for Accelerated Gradient Schemes, 2015).
      glm::vec3& by = steps[part];
      by *= glm::dot(forces[part], by) < 0 ? 0.0f : inertia;
      // Newton's step along the return force, whose slope is 1 / (1 + |r|).
      by += stride * (1 + std::min(glm::length(moves[part]), farthest)) / strengths.back * forces[part];
      const float length = glm::length(by);
      if (length > longest) by *= longest / length;
      moves[part] += by;
      moved = std::max(moved, std::min(length, longest));
    }
    if (moved < in_equilibrium) break;
  }
  for (glm::vec3& move : moves) move *= radius_;
  return moves;
}
