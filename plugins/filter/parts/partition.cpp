#include "partition.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

#include <glm/geometric.hpp>

namespace {

constexpr std::uint32_t none = lumen::Neighbor::none;

/// Lengths of the borders between parts, each pair once, the lower number first.
std::map<std::pair<std::uint32_t, std::uint32_t>, double> borders_of(const Surface& surface, const Partition& partition) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> borders;
  for (std::uint32_t i = 0; i < surface.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t other = surface.neighbors(i)[std::size_t(k)].triangle;
      if (other == none || other < i || partition.of_triangle[i] == partition.of_triangle[other]) continue;
      borders[std::minmax(partition.of_triangle[i], partition.of_triangle[other])] += surface.edge_length(i, k);
    }
  return borders;
}

/// Of each part that has one: the neighbor with the longest common border.
std::vector<std::uint32_t> closest_neighbors(const Surface& surface, const Partition& partition) {
  std::vector<std::uint32_t> closest(partition.areas.size(), none);
  std::vector<double> longest(partition.areas.size(), -1);
  for (const auto& [pair, length] : borders_of(surface, partition))
    for (const auto& [part, other] : {pair, std::pair(pair.second, pair.first)})
      if (length > longest[part]) longest[part] = length, closest[part] = other;
  return closest;
}

/// Parts as they are joined: each names another that it belongs to, or itself.
class Joined {
 public:
  explicit Joined(std::size_t count) : into_(count) { std::iota(into_.begin(), into_.end(), 0u); }
  std::uint32_t operator[](std::uint32_t part) {
    while (into_[part] != part) part = into_[part] = into_[into_[part]];
    return part;
  }
  void join(std::uint32_t part, std::uint32_t other) { into_[(*this)[part]] = (*this)[other]; }

 private:
  std::vector<std::uint32_t> into_;
};

/// The places of some of the large parts' triangles, and the part that is nearest to another place.
class Places {
 public:
  Places(const Surface& surface, const Partition& partition, const std::vector<bool>& small) {
    constexpr std::size_t most = 8192;
    const std::size_t step = surface.size() / most + 1;
    std::vector<std::uint32_t> passed(partition.areas.size(), 0);
    for (std::uint32_t i = 0; i < surface.size(); ++i)
      if (const std::uint32_t part = partition.of_triangle[i]; !small[part] && passed[part]++ % step == 0) places_.push_back({surface.center(i), part});
  }
  bool empty() const { return places_.empty(); }
  std::uint32_t nearest(const glm::vec3& from) const {
    const auto closer = [&](const Place& a, const Place& b) { return glm::distance(a.at, from) < glm::distance(b.at, from); };
    return std::min_element(places_.begin(), places_.end(), closer)->part;
  }

 private:
  struct Place {
    glm::vec3 at;
    std::uint32_t part;
  };
  std::vector<Place> places_;
};

}  // namespace

Partition partition_of(const Surface& surface, std::vector<std::uint32_t> of_triangle) {
  Partition partition{.of_triangle = std::move(of_triangle), .areas = {}};
  const auto last = std::max_element(partition.of_triangle.begin(), partition.of_triangle.end());
  partition.areas.assign(last == partition.of_triangle.end() ? 0 : *last + std::size_t(1), 0.0);
  for (std::uint32_t i = 0; i < surface.size(); ++i) partition.areas[partition.of_triangle[i]] += double(surface.area(i));
  return partition;
}

Partition runs_of(const Surface& surface, const std::vector<bool>& classes) {
  std::vector<std::uint32_t> run(surface.size(), none), open;
  std::uint32_t count = 0;
  for (std::uint32_t first = 0; first < surface.size(); ++first) {
    if (run[first] != none) continue;
    open.push_back(first);
    run[first] = count;
    while (!open.empty()) {
      const std::uint32_t triangle = open.back();
      open.pop_back();
      for (const lumen::Neighbor& neighbor : surface.neighbors(triangle))
        if (neighbor.triangle != none && run[neighbor.triangle] == none && classes[neighbor.triangle] == classes[triangle]) {
          run[neighbor.triangle] = count;
          open.push_back(neighbor.triangle);
        }
    }
    ++count;
  }
  return partition_of(surface, std::move(run));
}

Partition absorbed(const Surface& surface, Partition partition, double smallest) {
  const double least = smallest * surface.area();
  while (true) {
    std::vector<std::uint32_t> small(partition.areas.size());
    std::iota(small.begin(), small.end(), 0u);
    std::erase_if(small, [&](std::uint32_t part) { return partition.areas[part] >= least; });
    std::sort(small.begin(), small.end(), [&](std::uint32_t a, std::uint32_t b) { return partition.areas[a] < partition.areas[b]; });
    const std::vector<std::uint32_t> closest = closest_neighbors(surface, partition);
    Joined joined(partition.areas.size());
    std::vector<double> areas = partition.areas;
    bool any = false;
    for (const std::uint32_t part : small) {
      if (closest[part] == none || areas[joined[part]] >= least || joined[part] == joined[closest[part]]) continue;
      const double area = areas[joined[part]];
      joined.join(part, closest[part]);
      areas[joined[part]] += area;
      any = true;
    }
    if (!any) return partition;
    for (std::uint32_t& part : partition.of_triangle) part = joined[part];
    partition = partition_of(surface, std::move(partition.of_triangle));
  }
}

Partition numbered(const Surface& surface, const Partition& partition, double smallest, Specks specks) {
  std::vector<bool> small(partition.areas.size(), false);
  std::vector<std::uint32_t> joined(partition.areas.size());
  std::iota(joined.begin(), joined.end(), 0u);
  if (specks != Specks::keep)
    for (std::size_t part = 0; part < small.size(); ++part) small[part] = partition.areas[part] < smallest * surface.area();
  if (const Places places(surface, partition, small); specks == Specks::join && !places.empty()) {
    std::vector<bool> placed(small.size(), false);
    for (std::uint32_t i = 0; i < surface.size(); ++i)
      if (const std::uint32_t part = partition.of_triangle[i]; small[part] && !placed[part]) joined[part] = places.nearest(surface.center(i)), placed[part] = true;
    small.assign(small.size(), false);
  }
  std::vector<double> areas(partition.areas.size(), 0.0);
  for (std::size_t part = 0; part < areas.size(); ++part) areas[joined[part]] += partition.areas[part];
  std::vector<bool> used(areas.size(), false);  // not those that were absorbed
  for (const std::uint32_t part : partition.of_triangle) used[joined[part]] = true;
  std::vector<std::uint32_t> order;
  for (std::uint32_t part = 0; part < areas.size(); ++part)
    if (used[part] && !small[part]) order.push_back(part);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return areas[a] > areas[b]; });
  std::vector<std::uint32_t> number(areas.size(), std::uint32_t(order.size()));  // small ones together: the last
  for (std::uint32_t i = 0; i < order.size(); ++i) number[order[i]] = i;
  std::vector<std::uint32_t> of_triangle;
  of_triangle.reserve(surface.size());
  for (const std::uint32_t part : partition.of_triangle) of_triangle.push_back(number[joined[part]]);
  return partition_of(surface, std::move(of_triangle));
}
