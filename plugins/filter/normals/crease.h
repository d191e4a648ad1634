/// Smooth normals with creases: a point gets one normal per fan of triangles between sharp edges.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

enum class Weighting { area, angle, uniform };

/// A mesh whose points are split at creases.
struct CreasedMesh {
  std::vector<std::uint32_t> sources;   ///< which input point each point is a copy of; the first ones are the input's own
  std::vector<glm::vec3> normals;       ///< per point, unit; zero where no triangle is
  std::vector<glm::uvec3> triangles;    ///< in the input's order
};

/// Edges whose triangles' normals differ by more than `crease` radians are sharp, and so are boundaries. Nothing if the
/// triangles are no manifold: an edge of three or more, neighbors that face opposite ways. `progress` gets 0..1 and may throw.
std::optional<CreasedMesh> creased(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles, float crease, Weighting weighting,
                                   const std::function<void(float)>& progress);
