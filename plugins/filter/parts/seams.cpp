#include "seams.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <unordered_map>

#include <glm/geometric.hpp>

#include "minimum_cut.h"

namespace {

constexpr std::uint32_t none = lumen::Neighbor::none;

/// The triangles beside a seam of two parts, by how far they are from it.
class Band {
 public:
  Band(const Surface& surface, const Partition& partition, std::span<const float> thickness, std::uint32_t a, std::uint32_t b, const std::vector<std::uint32_t>& seam)
      : surface_(surface), partition_(partition), thickness_(thickness), a_(a), b_(b) {
    for (const std::uint32_t triangle : seam)
      if (within(triangle)) reach(triangle, 0);
  }

  /// Goes to `farthest`; what lies there is the band's rim.
  void spread(float farthest) {
    while (!open_.empty()) {
      const auto [distance, triangle] = open_.top();
      open_.pop();
      if (distance > distances_[triangle] || distance >= farthest) continue;
      for (const lumen::Neighbor& neighbor : surface_.neighbors(triangle))
        if (neighbor.triangle != none && partition_.of_triangle[neighbor.triangle] == partition_.of_triangle[triangle])
          reach(neighbor.triangle, distance + step(triangle, neighbor.triangle));
    }
    for (const auto& [triangle, distance] : distances_) {
      float& most = partition_.of_triangle[triangle] == a_ ? most_a_ : most_b_;
      most = std::max(most, distance);
    }
    // A part that lies within the reach keeps what is farthest from the seam.
    most_a_ = most_a_ >= farthest ? farthest : 0.5f * most_a_;
    most_b_ = most_b_ >= farthest ? farthest : 0.5f * most_b_;
  }

  bool is_rim(std::uint32_t triangle) const { return distances_.at(triangle) >= (partition_.of_triangle[triangle] == a_ ? most_a_ : most_b_); }
  const std::unordered_map<std::uint32_t, float>& distances() const { return distances_; }

 private:
  bool within(std::uint32_t triangle) const { return partition_.of_triangle[triangle] == a_ || partition_.of_triangle[triangle] == b_; }
  float step(std::uint32_t from, std::uint32_t to) const {
    const float thick = 0.5f * (thickness_[from] + thickness_[to]);
    return thick > 0 ? glm::distance(surface_.center(from), surface_.center(to)) / thick : 0;
  }
  void reach(std::uint32_t triangle, float distance) {
    const auto [place, fresh] = distances_.try_emplace(triangle, distance);
    if (!fresh && place->second <= distance) return;
    place->second = distance;
    open_.push({distance, triangle});
  }

  using Entry = std::pair<float, std::uint32_t>;
  const Surface& surface_;
  const Partition& partition_;
  std::span<const float> thickness_;
  std::uint32_t a_, b_;
  std::unordered_map<std::uint32_t, float> distances_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
  float most_a_ = 0, most_b_ = 0;
};

/// What it costs to cut an edge: its length over the thickness, less where the surface is bent inward by much of that.
double cost(const Surface& surface, std::span<const float> thickness, std::uint32_t triangle, int k) {
  const std::uint32_t other = surface.neighbors(triangle)[std::size_t(k)].triangle;
  const glm::vec3 normal = surface.normal(triangle), across = surface.center(other) - surface.center(triangle);
  const double thick = std::max(0.5 * (double(thickness[triangle]) + double(thickness[other])), 1e-30), apart = std::max(double(glm::length(across)), 1e-30);
  const double bend = std::acos(std::clamp(double(glm::dot(normal, surface.normal(other))), -1.0, 1.0));
  const double concave = glm::dot(normal, across) > 0 ? bend / apart * thick : 0;
  return double(surface.edge_length(triangle, k)) / thick / (1 + concave);
}

}  // namespace

Partition with_best_seams(const Surface& surface, Partition partition, std::span<const float> thickness, float reach, const std::function<void(float)>& progress) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> seams;
  for (std::uint32_t i = 0; i < surface.size(); ++i)
    for (const lumen::Neighbor& neighbor : surface.neighbors(i))
      if (neighbor.triangle != none && partition.of_triangle[i] != partition.of_triangle[neighbor.triangle])
        seams[std::minmax(partition.of_triangle[i], partition.of_triangle[neighbor.triangle])].push_back(i);
  float done = 0;
  for (const auto& [parts, seam] : seams) {
    const auto [a, b] = parts;
    const auto step = [&] { progress(done / float(seams.size())); };
    step();
    Band band(surface, partition, thickness, a, b, seam);
    band.spread(reach);
    std::vector<std::uint32_t> triangles;
    for (const auto& [triangle, distance] : band.distances()) triangles.push_back(triangle);
    std::sort(triangles.begin(), triangles.end());
    const auto node = [&](std::uint32_t triangle) { return std::uint32_t(std::lower_bound(triangles.begin(), triangles.end(), triangle) - triangles.begin()); };
    MinimumCut cut(triangles.size());
    constexpr double whole = 1 << 20;  // of a cost of 1, in integers: sums are exact
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
      const std::uint32_t triangle = triangles[i];
      if (band.is_rim(triangle)) cut.set_end(i, partition.of_triangle[triangle] == a ? MinimumCut::End::source : MinimumCut::End::sink);
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t other = surface.neighbors(triangle)[std::size_t(k)].triangle;
        if (other == none || other < triangle || !band.distances().contains(other)) continue;
        cut.add_edge(i, node(other), int(std::clamp(whole * cost(surface, thickness, triangle, k), 1.0, 1e8)));
      }
    }
    cut.run(step);
    for (std::uint32_t i = 0; i < triangles.size(); ++i) partition.of_triangle[triangles[i]] = cut.on_source_side(i) ? a : b;
    done += 1;
  }
  return partition_of(surface, std::move(partition.of_triangle));
}
