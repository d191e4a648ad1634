#include "sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include <glm/geometric.hpp>

namespace {

constexpr std::uint32_t leaf_size = 4;
constexpr double endless = std::numeric_limits<double>::infinity();

struct Extent {
  double low, high;
};

/// The least overlap is what one of both must move to come free.
bool apart(const Extent& a, const Extent& b, double tolerance) { return std::min(a.high - b.low, b.high - a.low) <= tolerance; }

using Points = std::array<glm::dvec3, 3>;

Points points_of(const Corners& corners) { return {glm::dvec3(corners[0]), glm::dvec3(corners[1]), glm::dvec3(corners[2])}; }

/// A triangle, and where it goes if it is swept.
struct Solid {
  Points points;
  std::optional<glm::dvec3> way;

  Extent along(const glm::dvec3& axis) const {
    const double a = glm::dot(axis, points[0]), b = glm::dot(axis, points[1]), c = glm::dot(axis, points[2]);
    Extent extent{std::min({a, b, c}), std::max({a, b, c})};
    const double drift = way ? glm::dot(axis, *way) : 0;
    if (drift > 1e-12) extent.high = endless;
    if (drift < -1e-12) extent.low = -endless;
    return extent;
  }
};

/// Some axis has both apart. Complete: normals of faces, and what is normal to two edges.
bool separated(const Solid& moving, const Points& still, double tolerance) {
  const Solid other{.points = still, .way = {}};
  const auto splits = [&](const glm::dvec3& axis) {
    const double length = glm::length(axis);
    if (!(length > 1e-30)) return false;
    const glm::dvec3 unit = axis / length;
    return apart(moving.along(unit), other.along(unit), tolerance);
  };
  std::array<glm::dvec3, 3> a, b;
  for (std::size_t i = 0; i < 3; ++i) {
    a[i] = moving.points[(i + 1) % 3] - moving.points[i];
    b[i] = still[(i + 1) % 3] - still[i];
  }
  const glm::dvec3 normal_a = glm::cross(a[0], a[1]), normal_b = glm::cross(b[0], b[1]);
  if (splits(normal_b) || splits(normal_a)) return true;
  for (std::size_t i = 0; i < 3; ++i) {
    // In their own planes: flat triangles side by side, and prisms that are flat themselves.
    if (splits(glm::cross(normal_a, a[i])) || splits(glm::cross(normal_b, b[i]))) return true;
    if (moving.way && (splits(glm::cross(*moving.way, a[i])) || splits(glm::cross(*moving.way, b[i])))) return true;
    for (const glm::dvec3& edge : b)
      if (splits(glm::cross(a[i], edge))) return true;
  }
  return false;
}

/// Walks both trees at once.
class Search {
 public:
  Search(const TriangleTree& moving, const TriangleTree& still, std::optional<Way> way, float tolerance, std::uint64_t most)
      : moving_(moving), still_(still), way_(way), tolerance_(tolerance), left_(most) {
    if (way) direction_ = glm::dvec3(way->vector());
  }

  Meeting run() {
    if (moving_.nodes().empty() || still_.nodes().empty()) return Meeting::none;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> open = {{0, 0}};
    while (!open.empty()) {
      const auto [a, b] = open.back();
      open.pop_back();
      const TriangleTree::Node &one = moving_.nodes()[a], &other = still_.nodes()[b];
      if (boxes_apart(one.bounds, other.bounds)) continue;
      if (left_-- == 0) return Meeting::given_up;
      if (one.right == 0 && other.right == 0) {
        if (leaves_meet(one, other)) return Meeting::some;
        if (left_ == 0) return Meeting::given_up;
      } else if (other.right == 0 || (one.right != 0 && one.bounds.radius() >= other.bounds.radius())) {
        open.emplace_back(one.right, b);
        open.emplace_back(a + 1, b);
      } else {
        open.emplace_back(a, other.right);
        open.emplace_back(a, b + 1);
      }
    }
    return Meeting::none;
  }

 private:
  bool boxes_apart(const lumen::Bounds& moving, const lumen::Bounds& still) const {
    for (int axis = 0; axis < 3; ++axis) {
      float low = moving.min[axis], high = moving.max[axis];
      if (way_ && way_->axis() == axis) (way_->sign() > 0 ? high : low) = way_->sign() * std::numeric_limits<float>::infinity();
      if (std::min(high - still.min[axis], still.max[axis] - low) <= tolerance_) return true;
    }
    return false;
  }

  bool leaves_meet(const TriangleTree::Node& one, const TriangleTree::Node& other) {
    for (std::uint32_t i = 0; i < one.count; ++i) {
      const Solid solid{points_of(moving_.triangle(one.first + i)), direction_};
      for (std::uint32_t k = 0; k < other.count && left_ > 0; ++k, --left_)
        if (!separated(solid, points_of(still_.triangle(other.first + k)), double(tolerance_))) return true;
    }
    return false;
  }

  const TriangleTree &moving_, &still_;
  std::optional<Way> way_;
  std::optional<glm::dvec3> direction_;
  float tolerance_;
  std::uint64_t left_;
};

}  // namespace

TriangleTree::TriangleTree(std::vector<Corners> triangles) : triangles_(std::move(triangles)) {
  if (triangles_.empty()) return;
  nodes_.reserve(triangles_.size());
  build(0, std::uint32_t(triangles_.size()));
}

void TriangleTree::build(std::uint32_t first, std::uint32_t count) {
  const auto own = std::uint32_t(nodes_.size());
  nodes_.emplace_back();
  lumen::Bounds bounds;
  for (std::uint32_t i = first; i < first + count; ++i)
    for (const glm::vec3& corner : triangles_[i]) bounds.include(corner);
  nodes_[own] = {.bounds = bounds, .first = first, .count = count};
  if (count <= leaf_size) return;
  const glm::vec3 size = bounds.max - bounds.min;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const auto begin = triangles_.begin() + first;
  const auto middle = [axis](const Corners& corners) { return corners[0][axis] + corners[1][axis] + corners[2][axis]; };
  std::nth_element(begin, begin + count / 2, begin + count, [&](const Corners& a, const Corners& b) { return middle(a) < middle(b); });
  build(first, count / 2);
  nodes_[own].right = std::uint32_t(nodes_.size());
  build(first + count / 2, count - count / 2);
}

Meeting meeting_on_way(const TriangleTree& moving, const TriangleTree& still, Way way, float tolerance, std::uint64_t most) {
  return Search(moving, still, way, tolerance, most).run();
}

Meeting meeting_at_rest(const TriangleTree& a, const TriangleTree& b, float tolerance, std::uint64_t most) { return Search(a, b, {}, tolerance, most).run(); }
