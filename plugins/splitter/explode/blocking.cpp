#include "blocking.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace {

/// Contacts are as exact as single precision allows; relative to the radius of all.
constexpr float touching = 1e-5f;
/// Pairs of boxes and triangles that are looked at for one pair of parts and one direction.
constexpr std::uint64_t most_pairs = 4'000'000;

}  // namespace

Blocking::Blocking(const Pieces& pieces, const glm::mat3& axes)
    : count_(int(pieces.list.size())), axes_(axes), tolerance_(touching * pieces.radius), ways_(pieces.list.size() * pieces.list.size()), intersect_(ways_.size(), false) {
  std::vector<TriangleTree> trees;
  trees.reserve(pieces.list.size());
  const glm::mat3 to_frame = glm::transpose(axes);
  for (const Piece& piece : pieces.list) {
    std::vector<Corners> turned;
    turned.reserve(piece.triangles.size());
    for (const Corners& corners : piece.triangles) {
      turned.push_back({});
      // About the center: what is far from the origin keeps its digits.
      for (std::size_t i = 0; i < 3; ++i) turned.back()[i] = to_frame * (corners[i] - pieces.center);
    }
    trees.emplace_back(std::move(turned));
    bounds_.push_back(trees.back().nodes().front().bounds);
  }
  for (int a = 0; a < count_; ++a)
    for (int b = a + 1; b < count_; ++b) find_pair(a, b, trees[std::size_t(a)], trees[std::size_t(b)]);
}

void Blocking::find_pair(int a, int b, const TriangleTree& tree_a, const TriangleTree& tree_b) {
  const Meeting rest = meeting_at_rest(tree_a, tree_b, tolerance_, most_pairs);
  if (rest == Meeting::some) {
    intersect_[index(a, b)] = intersect_[index(b, a)] = true;
    ++intersecting_;
    return;
  }
  bool given_up = rest == Meeting::given_up;
  for (int i = 0; i < Way::count; ++i) {
    const Way way{i};
    const Meeting meeting = given_up ? Meeting::given_up : meeting_on_way(tree_a, tree_b, way, tolerance_, most_pairs);
    given_up = meeting == Meeting::given_up;
    if (meeting == Meeting::none) continue;
    ways_[index(a, b)].set(std::size_t(way.index));
    ways_[index(b, a)].set(std::size_t(way.back().index));
  }
  given_up_ += given_up;
}

glm::mat3 principal_axes(const Pieces& pieces) {
  glm::dvec3 mean(0);
  double total = 0;
  const auto each = [&](auto&& body) {
    for (const Piece& piece : pieces.list)
      for (const Corners& c : piece.triangles) {
        const double area = double(glm::length(glm::cross(c[1] - c[0], c[2] - c[0])));
        body(glm::dvec3(c[0] + c[1] + c[2]) / 3.0 - glm::dvec3(pieces.center), area);
      }
  };
  each([&](const glm::dvec3& at, double area) { mean += area * at, total += area; });
  if (!(total > 0)) return glm::mat3(1);
  mean /= total;
  glm::dmat3 spread(0), axes(1);
  each([&](const glm::dvec3& at, double area) { spread += area / total * glm::outerProduct(at - mean, at - mean); });
  // Jacobi's rotations: the largest entry off the diagonal becomes 0.
  const double least = 1e-9 * (spread[0][0] + spread[1][1] + spread[2][2]);
  for (int step = 0; step < 60; ++step) {
    int p = 0, q = 1;
    if (std::abs(spread[0][2]) > std::abs(spread[p][q])) p = 0, q = 2;
    if (std::abs(spread[1][2]) > std::abs(spread[p][q])) p = 1, q = 2;
    if (std::abs(spread[p][q]) <= least) break;
    const double angle = 0.5 * std::atan2(2 * spread[p][q], spread[q][q] - spread[p][p]), c = std::cos(angle), s = std::sin(angle);
    glm::dmat3 turn(1);
    turn[p][p] = turn[q][q] = c;
    turn[p][q] = -s;
    turn[q][p] = s;
    spread = glm::transpose(turn) * spread * turn;
    axes = axes * turn;
  }
  for (int i = 0; i < 2; ++i) {
    const glm::dvec3 size = glm::abs(axes[i]);
    const int largest = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    if (axes[i][largest] < 0) axes[i] = -axes[i];
  }
  axes[2] = glm::cross(axes[0], axes[1]);
  return glm::mat3(axes);
}
