/// Ring by ring; normals from the differences along and around.
#include "tube.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace {

constexpr float pi = std::numbers::pi_v<float>;

/// Where a ring lies, and by how much the rounding of an end shrinks it.
struct Station {
  float distance, scale;
};

/// Rings at the angles of a rounded end, the rest evenly between.
std::vector<Station> stations_of(const Tube& tube, int rings) {
  const auto radius_at = [&](float distance) { return tube.section->mean_radius(tube.line->at(distance), distance); };
  const float length = tube.end - tube.begin;
  const float begin_height = std::min(tube.begin_rounding * radius_at(tube.begin), 0.4f * length);
  const float end_height = std::min(tube.end_rounding * radius_at(tube.end), 0.4f * length);
  const auto count_of = [&](float height) {
    const float share = height * pi / 2 / (length - begin_height - end_height + (begin_height + end_height) * pi / 2);
    return std::clamp(static_cast<int>(std::lround(share * static_cast<float>(rings))), 1, std::max(1, rings / 3));
  };
  const int begin_count = count_of(begin_height), end_count = count_of(end_height), middle = rings - begin_count - end_count;

  std::vector<Station> stations;
  stations.reserve(static_cast<std::size_t>(rings));
  const auto scale_of = [](float rounding, float angle) { return 1 - rounding * (1 - std::cos(angle)); };
  for (int ring = 0; ring < begin_count; ++ring) {
    const float angle = pi / 2 * (1 - static_cast<float>(ring + 1) / static_cast<float>(begin_count + 1));
    stations.push_back({tube.begin + begin_height * (1 - std::sin(angle)), scale_of(tube.begin_rounding, angle)});
  }
  for (int ring = 0; ring < middle; ++ring) {
    const float t = middle > 1 ? static_cast<float>(ring) / static_cast<float>(middle - 1) : 0.5f;
    stations.push_back({tube.begin + begin_height + t * (length - begin_height - end_height), 1});
  }
  for (int ring = 0; ring < end_count; ++ring) {
    const float angle = pi / 2 * static_cast<float>(ring + 1) / static_cast<float>(end_count + 1);
    stations.push_back({tube.end - end_height * (1 - std::sin(angle)), scale_of(tube.end_rounding, angle)});
  }
  return stations;
}

}  // namespace

TubeGrid grid_of(const Tube& tube, float edge) {
  constexpr int probes = 16;
  float mean = 0, length = tube.end - tube.begin;
  for (int probe = 0; probe < probes; ++probe) {
    const float distance = tube.begin + length * (static_cast<float>(probe) + 0.5f) / probes;
    mean += tube.section->mean_radius(tube.line->at(distance), distance) / probes;
  }
  length += (tube.begin_rounding + tube.end_rounding) * (pi / 2 - 1) * mean;
  return {std::max(4, static_cast<int>(std::lround(2 * pi * mean / edge))), std::max(4, static_cast<int>(std::lround(length / edge)))};
}

void add_tube(Shell& shell, const Tube& tube, TubeGrid grid, const Progress& progress) {
  const auto around = static_cast<std::uint32_t>(grid.around), rings = static_cast<std::uint32_t>(grid.rings);
  std::vector<glm::vec2> directions(around);
  for (std::uint32_t index = 0; index < around; ++index) {
    const float angle = 2 * pi * static_cast<float>(index) / static_cast<float>(around);
    directions[index] = {std::cos(angle), std::sin(angle)};
  }
  const auto pressure_at = [&](float distance) {
    return glm::mix(tube.pressure_begin, tube.pressure_end, (distance - tube.begin) / (tube.end - tube.begin));
  };
  std::vector<float> radii(around);
  const auto center_of = [&](const CurveFrame& frame, float distance) {
    const glm::vec2 offset = tube.section->evaluate(frame, distance, directions, radii);
    return frame.position + offset.x * frame.right + offset.y * frame.up;
  };

  const CurveFrame first_frame = tube.line->at(tube.begin), last_frame = tube.line->at(tube.end);
  const std::uint32_t first_pole = shell.add(center_of(first_frame, tube.begin), 0, pressure_at(tube.begin));
  const std::uint32_t base = first_pole + 1;
  const std::vector<Station> stations = stations_of(tube, grid.rings);
  for (std::uint32_t ring = 0; ring < rings; ++ring) {
    if (ring % 32 == 0) progress(static_cast<float>(ring) / static_cast<float>(rings));
    const Station station = stations[ring];
    const CurveFrame frame = tube.line->at(station.distance);
    const glm::vec3 center = center_of(frame, station.distance);
    const float pressure = pressure_at(station.distance);
    for (std::uint32_t index = 0; index < around; ++index) {
      const glm::vec2 offset = station.scale * radii[index] * directions[index];
      const glm::vec3 position = center + offset.x * frame.right + offset.y * frame.up;
      // Slow flow along the inner curve: pressure falls a little with the distance.
      shell.add(position, glm::distance(position, frame.position), pressure + 0.4f * directions[index].x * radii[index]);
    }
  }
  const std::uint32_t last_pole = shell.add(center_of(last_frame, tube.end), 0, pressure_at(tube.end));

  const auto at = [&](std::uint32_t ring, std::uint32_t index) { return base + ring * around + index; };
  for (std::uint32_t index = 0; index < around; ++index) {
    const std::uint32_t next = (index + 1) % around;
    shell.triangles.emplace_back(first_pole, at(0, next), at(0, index));
    shell.triangles.emplace_back(last_pole, at(rings - 1, index), at(rings - 1, next));
  }
  for (std::uint32_t ring = 0; ring + 1 < rings; ++ring)
    for (std::uint32_t index = 0; index < around; ++index) {
      const std::uint32_t next = index + 1 < around ? index + 1 : 0;
      shell.triangles.emplace_back(at(ring, index), at(ring, next), at(ring + 1, next));
      shell.triangles.emplace_back(at(ring, index), at(ring + 1, next), at(ring + 1, index));
    }

  shell.normals[first_pole] = -first_frame.forward;
  shell.normals[last_pole] = last_frame.forward;
  for (std::uint32_t ring = 0; ring < rings; ++ring)
    for (std::uint32_t index = 0; index < around; ++index) {
      const glm::vec3& left = shell.positions[at(ring, index > 0 ? index - 1 : around - 1)];
      const glm::vec3& right = shell.positions[at(ring, index + 1 < around ? index + 1 : 0)];
      const glm::vec3& back = shell.positions[ring > 0 ? at(ring - 1, index) : first_pole];
      const glm::vec3& ahead = shell.positions[ring + 1 < rings ? at(ring + 1, index) : last_pole];
      shell.normals[at(ring, index)] = glm::normalize(glm::cross(right - left, ahead - back));
    }
}
