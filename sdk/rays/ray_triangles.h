/// Triangles that rays meet, as Embree holds them. For plugins that link lumen-rays.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>

#include <glm/vec3.hpp>

namespace lumen {

/// Filled by one thread; once built, many may ask.
class RayTriangles {
 public:
  /// To be filled before build(): positions, and each triangle's corners among them.
  struct Room {
    std::span<glm::vec3> positions;
    std::span<glm::uvec3> triangles;
  };
  struct Hit {
    float distance;          ///< along the ray
    std::uint32_t triangle;  ///< of its room
    glm::vec3 normal;        ///< by the order of its corners, not unit
  };

  RayTriangles();            ///< Throws Error if Embree fails.
  ~RayTriangles();
  RayTriangles(const RayTriangles&) = delete;
  RayTriangles& operator=(const RayTriangles&) = delete;

  /// `removed`: rays go on where it answers yes for the place of a hit; called by the threads that ask. Throws Error (out of memory).
  Room add(std::size_t positions, std::size_t triangles, std::function<bool(const glm::vec3&)> removed = {});
  /// Throws Error (out of memory).
  void build();
  std::size_t bytes() const;  ///< of triangles and hierarchy

  /// Whether the ray from `origin` along a unit direction meets anything nearer than `reach`.
  bool occluded(glm::vec3 origin, glm::vec3 direction, float reach) const;
  /// What it meets first, farther than `from`.
  std::optional<Hit> first(glm::vec3 origin, glm::vec3 direction, float from, float reach) const;

 private:
  struct Embree;
  std::unique_ptr<Embree> embree_;
};

}  // namespace lumen
