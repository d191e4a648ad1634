#include "clusters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include <glm/gtc/constants.hpp>

#include <topology/orientation.h>

namespace {

/// Bits of 0..31, each followed by two zeros.
std::uint32_t spread(std::uint32_t x) {
  std::uint32_t spread = 0;
  for (int bit = 0; bit < 5; ++bit) spread |= (x >> bit & 1) << 3 * bit;
  return spread;
}

/// Where each triangle goes, so that neighbors stand together and clusters are runs: the cells of a grid along a space-filling
/// curve (Morton), triangles of a cell in their own order. Triangles that face the six main directions lie on curves of their
/// own, one after the other, so that a cluster faces one way even where two walls touch.
std::vector<std::uint32_t> places(const lumen::Mesh& mesh) {
  constexpr int cells = 32;
  std::array<std::uint32_t, cells> curve;
  for (int i = 0; i < cells; ++i) curve[std::size_t(i)] = spread(std::uint32_t(i));
  const lumen::Bounds bounds = mesh.bounds();
  const glm::vec3 to_cell = float(cells) / (3.0f * glm::max(bounds.max - bounds.min, glm::vec3(1e-30f)));
  std::vector<std::uint32_t> place(mesh.triangles.size()), next(6 * cells * cells * cells + 1, 0);
  for (std::size_t i = 0; i < place.size(); ++i) {
    const glm::uvec3& t = mesh.triangles[i];
    const glm::vec3 &p = mesh.positions[t.x], &q = mesh.positions[t.y], &r = mesh.positions[t.z];
    const glm::vec3 normal = glm::cross(q - p, r - p), size = glm::abs(normal);
    const int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    const glm::ivec3 cell = glm::clamp(glm::ivec3((p + q + r - 3.0f * bounds.min) * to_cell), 0, cells - 1);
    const auto direction = std::uint32_t(2 * axis + (normal[axis] < 0));
    place[i] = direction * cells * cells * cells + (curve[std::size_t(cell.x)] | curve[std::size_t(cell.y)] << 1 | curve[std::size_t(cell.z)] << 2);
    ++next[place[i] + 1];
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  for (std::uint32_t& key : place) key = next[key]++;
  return place;
}

/// The places with group after group, in each the order as it was.
std::vector<std::uint32_t> grouped(std::vector<std::uint32_t> place, const Groups& groups) {
  if (groups == nullptr) return place;
  std::vector<std::uint32_t> at(place.size()), next(1);
  for (std::size_t i = 0; i < place.size(); ++i) {
    at[place[i]] = std::uint32_t(i);
    const std::uint32_t group = (*groups)[i];
    if (next.size() < std::size_t(group) + 2) next.resize(std::size_t(group) + 2);
    ++next[group + 1];
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  for (const std::uint32_t triangle : at) place[triangle] = next[(*groups)[triangle]]++;
  return place;
}

/// The sphere about the box of the points, and the cone about the mean direction.
Cluster cluster_of(const lumen::Mesh& mesh, std::span<const glm::uvec3> triangles, std::uint32_t first, std::uint32_t count) {
  Cluster cluster{.first = first, .count = count};
  std::array<glm::vec3, 3 * cluster_size> corners;  // gathered once
  for (std::uint32_t i = 0; i < count; ++i)
    for (int corner = 0; corner < 3; ++corner) corners[3 * i + std::uint32_t(corner)] = mesh.positions[triangles[first + i][corner]];
  const std::span<const glm::vec3> used(corners.data(), 3 * std::size_t(count));
  std::array<glm::vec3, cluster_size> normals;
  glm::vec3 low(std::numeric_limits<float>::infinity()), high(-low), sum(0);
  for (const glm::vec3& point : used) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const glm::vec3 &p = corners[3 * i], normal = glm::cross(corners[3 * i + 1] - p, corners[3 * i + 2] - p);
    const float length = glm::length(normal);
    normals[i] = length > 0 ? normal / length : glm::vec3(0);  // nobody sees a triangle without area
    sum += normals[i];
  }
  cluster.center = 0.5f * (low + high);
  float square = 0, narrowest = 1;
  for (const glm::vec3& point : used) square = std::max(square, glm::dot(point - cluster.center, point - cluster.center));
  cluster.radius = std::sqrt(square);
  if (glm::length(sum) == 0) return cluster;
  cluster.axis = glm::normalize(sum);
  for (std::uint32_t i = 0; i < count; ++i)
    if (normals[i] != glm::vec3(0)) narrowest = std::min(narrowest, glm::dot(normals[i], cluster.axis));
  // Near a right angle nothing would be left out; some room for rounding.
  if (narrowest > 0.1f) cluster.cutoff = std::min(1.0f, std::sqrt(std::max(0.0f, 1 - narrowest * narrowest)) + 1e-4f);
  return cluster;
}

}  // namespace

ClusteredMesh make_clusters(const lumen::Mesh& mesh, const Groups& groups) {
  ClusteredMesh result;
  const std::size_t count = mesh.triangles.size();
  result.count = std::uint32_t(count);
  if (count == 0) return result;
  const lumen::Orientation orientation = lumen::orientation_of(mesh);
  result.solid = orientation.solid;

  const std::vector<std::uint32_t> place = grouped(places(mesh), groups);
  result.triangles.resize(count);
  std::vector<std::uint32_t> group(groups == nullptr ? 0 : count);
  for (std::size_t i = 0; i < count; ++i) {
    const glm::uvec3& triangle = mesh.triangles[i];
    result.triangles[place[i]] = !orientation.turned.empty() && orientation.turned[i] ? glm::uvec3(triangle.x, triangle.z, triangle.y) : triangle;
    if (groups != nullptr) group[place[i]] = (*groups)[i];
  }
  result.clusters.reserve(count / cluster_size + 1);
  for (std::uint32_t first = 0, end; first < count; first = end) {
    end = std::min(first + cluster_size, std::uint32_t(count));
    if (groups != nullptr) end = std::uint32_t(std::upper_bound(group.begin() + first, group.begin() + end, group[first]) - group.begin());
    result.clusters.push_back(cluster_of(mesh, result.triangles, first, end - first));
    if (groups != nullptr) result.clusters.back().group = group[first];
  }
  return result;
}

std::vector<std::uint32_t> drawn_cells(const lumen::Mesh& mesh, const Groups& groups) {
  const std::vector<std::uint32_t> place = grouped(places(mesh), groups);
  std::vector<std::uint32_t> cells(place.size());
  for (std::size_t i = 0; i < place.size(); ++i) cells[place[i]] = mesh.triangle_cells.empty() ? std::uint32_t(i) : mesh.triangle_cells[i];
  return cells;
}

namespace {

/// Every triangle of the cluster faces away from the eye.
bool faces_away(const Cluster& cluster, const Visibility& visibility) {
  if (cluster.cutoff >= 1) return false;
  if (visibility.orthographic) return glm::dot(visibility.eye, cluster.axis) >= cluster.cutoff;
  const glm::vec3 way = cluster.center - visibility.eye;
  return glm::dot(way, cluster.axis) >= cluster.cutoff * glm::length(way) + cluster.radius;
}

/// A ray of the eye may meet both spheres: where it looks in parallel, their shadows touch; else, the cones about them do.
bool seen_together(const glm::vec4& opening, const Cluster& cluster, const Visibility& visibility) {
  const glm::vec3 center(opening);
  if (visibility.orthographic) {
    const glm::vec3 across = center - cluster.center;
    const float along = glm::dot(across, visibility.eye), reach = opening.w + cluster.radius;
    return glm::dot(across, across) - along * along <= reach * reach;
  }
  const glm::vec3 a = center - visibility.eye, b = cluster.center - visibility.eye;
  const float far_a = glm::length(a), far_b = glm::length(b);
  if (far_a <= opening.w || far_b <= cluster.radius) return true;
  const float widths = std::asin(opening.w / far_a) + std::asin(cluster.radius / far_b);
  return widths >= glm::pi<float>() || glm::dot(a, b) >= std::cos(widths) * far_a * far_b;
}

}  // namespace

std::vector<std::uint32_t> number_points(ClusteredMesh& mesh, std::size_t points) {
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(points, none), former;
  former.reserve(points);
  for (Cluster& cluster : mesh.clusters) {
    cluster.first_point = std::uint32_t(former.size());
    for (std::uint32_t i = cluster.first; i < cluster.first + cluster.count; ++i)
      for (int corner = 0; corner < 3; ++corner) {
        std::uint32_t& point = mesh.triangles[i][corner];
        if (number[point] == none) {
          number[point] = std::uint32_t(former.size());
          former.push_back(point);
        }
        point = number[point];
      }
    cluster.points = std::uint32_t(former.size()) - cluster.first_point;
  }
  return former;
}

void visible_clusters(const ClusteredMesh& mesh, const Visibility& visibility, std::vector<SeenCluster>& seen) {
  seen.clear();
  for (std::uint32_t i = 0; i < mesh.clusters.size(); ++i) {
    const Cluster& cluster = mesh.clusters[i];
    if (visibility.group >= 0 && cluster.group != std::uint32_t(visibility.group)) continue;
    const auto beyond = [&](const glm::vec4& plane, float distance) { return glm::dot(glm::vec3(plane), cluster.center) + plane.w < distance; };
    const auto outside = [&](const glm::vec4& plane) { return beyond(plane, -cluster.radius); };
    if (std::any_of(visibility.planes.begin(), visibility.planes.end(), outside) || std::any_of(visibility.cuts.begin(), visibility.cuts.end(), outside)) continue;
    const bool backs = !visibility.skip_backs || std::any_of(visibility.openings.begin(), visibility.openings.end(),
                                                             [&](const glm::vec4& opening) { return seen_together(opening, cluster, visibility); });
    if (!backs && faces_away(cluster, visibility)) continue;
    const bool cut = std::any_of(visibility.cuts.begin(), visibility.cuts.end(), [&](const glm::vec4& plane) { return beyond(plane, cluster.radius); });
    seen.push_back({.cluster = i, .backs = backs, .cut = cut});
  }
}

void runs_of(const ClusteredMesh& mesh, std::span<const SeenCluster> seen, std::vector<Run>& runs) {
  runs.clear();
  for (const SeenCluster& each : seen) {
    const Cluster& cluster = mesh.clusters[each.cluster];
    if (!runs.empty() && runs.back().first + runs.back().count == cluster.first) runs.back().count += cluster.count;
    else runs.push_back({cluster.first, cluster.count});
  }
}

std::vector<Run> runs_of_group(const ClusteredMesh& mesh, int group) {
  std::vector<SeenCluster> seen;
  std::vector<Run> runs;
  visible_clusters(mesh, {.group = group}, seen);
  runs_of(mesh, seen, runs);
  return runs;
}
