#include "sheets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <tuple>
#include <unordered_map>

#include <glm/geometric.hpp>

namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// A side of a triangle: from its corner `number % 3` to the next.
struct EdgeUse {
  std::uint32_t low, high;   ///< points
  std::uint32_t number;      ///< 3 * triangle + corner
};

class Separation {
 public:
  Separation(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles) : positions_(positions), triangles_(triangles.begin(), triangles.end()) {}

  Sheets run() {
    leave_out_doubles();
    pair_edges();
    Sheets sheets = parted();
    // Two sheets that hang together around both ends of an edge cannot be told apart there, but the other way of joining them may.
    if (find_crowded(sheets)) {
      pair_edges();
      sheets = parted();
    }
    sheets.sources = std::move(sources_);
    turn(sheets);
    return sheets;
  }

 private:
  std::uint32_t corner(std::uint32_t number) const { return triangles_[number / 3][int(number % 3)]; }
  static std::uint32_t next(std::uint32_t number) { return number - number % 3 + (number + 1) % 3; }
  std::uint32_t opposite(std::uint32_t number) const { return corner(next(next(number))); }

  void leave_out_doubles() {
    using Corners = std::array<std::uint32_t, 3>;
    std::vector<std::pair<Corners, std::uint32_t>> sorted;
    sorted.reserve(triangles_.size());
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
      Corners corners{triangles_[i].x, triangles_[i].y, triangles_[i].z};
      std::sort(corners.begin(), corners.end());
      sorted.emplace_back(corners, i);
    }
    std::sort(sorted.begin(), sorted.end());
    const auto edge = [](const Corners& corners) { return std::uint64_t(corners[0]) << 32 | corners[1]; };
    std::unordered_map<std::uint64_t, std::size_t> uses;  // of an edge of each of them
    for (std::size_t i = 0; i + 1 < sorted.size(); ++i)
      if (sorted[i].first == sorted[i + 1].first) uses.emplace(edge(sorted[i].first), 0);
    for (const auto& [corners, number] : sorted)
      for (const Corners& side : {Corners{corners[0], corners[1]}, Corners{corners[1], corners[2]}, Corners{corners[0], corners[2]}})
        if (const auto found = uses.find(edge(side)); found != uses.end()) ++found->second;
    std::vector<bool> out(triangles_.size());
    for (std::size_t i = 0; i + 1 < sorted.size(); ++i) {
      if (sorted[i].first != sorted[i + 1].first) continue;
      std::size_t& left = uses.at(edge(sorted[i].first));
      const bool both = left % 2 == 0;
      left -= both ? 2 : 1;
      out[sorted[i].second] = true;
      if (both) out[sorted[++i].second] = true;
    }
    for (std::uint32_t i = 0; i < triangles_.size(); ++i)
      if (!out[i]) triangles_[sources_.size()] = triangles_[i], sources_.push_back(i);
    triangles_.resize(sources_.size());
  }

  void pair_edges() {
    std::vector<EdgeUse> uses;
    uses.reserve(triangles_.size() * 3);
    for (std::uint32_t number = 0; number < triangles_.size() * 3; ++number) {
      const std::uint32_t a = corner(number), b = corner(next(number));
      uses.push_back({std::min(a, b), std::max(a, b), number});
    }
    std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) { return std::tie(a.low, a.high, a.number) < std::tie(b.low, b.high, b.number); });
    partner_.assign(uses.size(), none);
    full_.clear();
    for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
      while (end < uses.size() && uses[end].low == uses[begin].low && uses[end].high == uses[begin].high) ++end;
      pair(std::span(uses).subspan(begin, end - begin));
    }
  }

  /// Those of one edge.
  void pair(std::span<EdgeUse> uses) {
    const auto join = [&](const EdgeUse& a, const EdgeUse& b) {
      partner_[a.number] = b.number;
      partner_[b.number] = a.number;
    };
    if (uses.size() == 2) return join(uses[0], uses[1]);
    if (uses.size() < 4 || uses.size() % 2 != 0) return;  // of an odd number, none is less of a border than the others
    full_.insert(full_.end(), uses.begin(), uses.end());
    const glm::dvec3 low(positions_[uses[0].low]), along = glm::normalize(glm::dvec3(positions_[uses[0].high]) - low);
    const auto across = [&](const EdgeUse& use) {
      const glm::dvec3 to = glm::dvec3(positions_[opposite(use.number)]) - low;
      return to - glm::dot(to, along) * along;
    };
    const glm::dvec3 right = across(uses[0]), up = glm::cross(along, right);
    const auto angle = [&](const EdgeUse& use) {
      const double turned = std::atan2(glm::dot(across(use), up), glm::dot(across(use), right));
      return turned < 0 ? turned + 2 * std::numbers::pi : turned >= 0 ? turned : 0;  // an edge without length has no angles
    };
    std::stable_sort(uses.begin(), uses.end(), [&](const EdgeUse& a, const EdgeUse& b) { return angle(a) < angle(b); });
    double enclosed = 0;  // between the first and the second, the third and the fourth ...
    for (std::size_t i = 0; i < uses.size(); i += 2) enclosed += angle(uses[i + 1]) - angle(uses[i]);
    const std::size_t first = (enclosed <= std::numbers::pi) == crowded_.contains({uses[0].low, uses[0].high}) ? 1 : 0;
    for (std::size_t i = 0; i < uses.size(); i += 2) join(uses[i + first], uses[(i + first + 1) % uses.size()]);
  }

  /// Corners that edges join are one point; a point of several such fans gets copies.
  Sheets parted() const {
    Sheets sheets{.triangles = triangles_};
    std::vector<std::uint32_t> parent(triangles_.size() * 3);
    std::iota(parent.begin(), parent.end(), 0u);
    const auto root = [&](std::uint32_t i) {
      while (parent[i] != i) i = parent[i] = parent[parent[i]];
      return i;
    };
    for (std::uint32_t number = 0; number < partner_.size(); ++number) {
      const std::uint32_t other = partner_[number];
      if (other == none || other < number) continue;
      const bool same_way = corner(number) == corner(other);
      parent[root(number)] = root(same_way ? other : next(other));
      parent[root(next(number))] = root(same_way ? next(other) : other);
    }
    std::vector<std::uint32_t> fan_of_point(positions_.size(), none), point_of_fan(parent.size(), none);
    for (std::uint32_t number = 0; number < parent.size(); ++number) {
      const std::uint32_t fan = root(number), point = corner(number);
      if (fan_of_point[point] == none) fan_of_point[point] = fan;
      if (point_of_fan[fan] == none) {
        point_of_fan[fan] = point;
        if (fan_of_point[point] != fan) {
          point_of_fan[fan] = std::uint32_t(positions_.size() + sheets.copies.size());
          sheets.copies.push_back(point);
        }
      }
      sheets.triangles[number / 3][int(number % 3)] = point_of_fan[fan];
    }
    return sheets;
  }

  /// Edges whose uses are still more than two.
  bool find_crowded(const Sheets& sheets) {
    const auto at = [&](std::uint32_t number) { return sheets.triangles[number / 3][int(number % 3)]; };
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
    const auto ends = [&](const EdgeUse& use) { return std::pair(std::minmax({at(use.number), at(next(use.number))})); };
    for (const EdgeUse& use : full_) ++uses[ends(use)];
    for (const EdgeUse& use : full_)
      if (uses[ends(use)] > 2) crowded_.insert({use.low, use.high});
    return !crowded_.empty();
  }

  void turn(Sheets& sheets) const {
    enum class Way : std::uint8_t { unknown, kept, turned };
    std::vector<Way> ways(triangles_.size(), Way::unknown);
    for (std::uint32_t first = 0; first < triangles_.size(); ++first) {
      if (ways[first] != Way::unknown) continue;
      ways[first] = Way::kept;
      std::vector<std::uint32_t> sheet{first};
      double kept = 0, turned = 0;
      for (std::size_t at = 0; at < sheet.size(); ++at) {
        (ways[sheet[at]] == Way::kept ? kept : turned) += doubled_area(sheet[at]);
        for (std::uint32_t number = 3 * sheet[at]; number < 3 * sheet[at] + 3; ++number) {
          const std::uint32_t other = partner_[number];
          if (other == none || ways[other / 3] != Way::unknown) continue;
          const bool against = corner(number) == corner(other);  // the same direction: they face opposite ways
          ways[other / 3] = (ways[sheet[at]] == Way::kept) == against ? Way::turned : Way::kept;
          sheet.push_back(other / 3);
        }
      }
      const Way smaller = turned <= kept ? Way::turned : Way::kept;
      for (const std::uint32_t triangle : sheet) {
        if (ways[triangle] != smaller) continue;
        std::swap(sheets.triangles[triangle].y, sheets.triangles[triangle].z);
        ++sheets.turned;
      }
    }
  }

  double doubled_area(std::uint32_t triangle) const {
    const glm::uvec3& t = triangles_[triangle];
    return double(glm::length(glm::cross(positions_[t.y] - positions_[t.x], positions_[t.z] - positions_[t.x])));
  }

  std::span<const glm::vec3> positions_;
  std::vector<glm::uvec3> triangles_;
  std::vector<std::uint32_t> sources_;  ///< which of the given triangles each is
  std::vector<EdgeUse> full_;           ///< of edges where more than two triangles meet
  std::set<std::pair<std::uint32_t, std::uint32_t>> crowded_;  ///< edges to be joined in the other way
  std::vector<std::uint32_t> partner_;  ///< of each side of a triangle: the side of another that it is joined with, or none
};

}  // namespace

Sheets sheets_of(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles) { return Separation(positions, triangles).run(); }
