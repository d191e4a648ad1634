/// A mesh in clusters of neighboring triangles, so that whole clusters that cannot be seen are not drawn.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include <lumen/mesh.h>

/// Where a cluster lies and which way its triangles face. Object space.
struct Cluster {
  std::uint32_t first = 0, count = 0;  ///< triangles, in the drawn order
  std::uint32_t first_point = 0, points = 0;  ///< that no cluster before it uses; number_points() sets them
  std::uint32_t group = 0;             ///< of its triangles, 0 if there are no groups
  glm::vec3 center{0};
  float radius = 0;
  glm::vec3 axis{0};                   ///< unit
  float cutoff = 1;                    ///< sine of the widest angle to the axis; 1 = faces every way
};

inline constexpr std::uint32_t cluster_size = 128;  ///< triangles, at most

struct ClusteredMesh {
  std::vector<glm::uvec3> triangles;   ///< neighbors stand together
  std::vector<Cluster> clusters;
  std::uint32_t count = 0;             ///< of triangles
  /// Closed, and turned outward everywhere: seen from outside, what faces away is hidden.
  bool solid = false;
};

/// The group of each triangle, or nothing: then all are of one group.
using Groups = std::shared_ptr<const std::vector<std::uint32_t>>;

/// A cluster holds triangles of one group, and clusters of one group stand together.
ClusteredMesh make_clusters(const lumen::Mesh& mesh, const Groups& groups);
/// The source cell of each triangle in the drawn order.
std::vector<std::uint32_t> drawn_cells(const lumen::Mesh& mesh, const Groups& groups);

/// Numbers the points as the triangles use them, so that those of a cluster lie side by side. Returns the former number of
/// each; points that no triangle uses are left out.
std::vector<std::uint32_t> number_points(ClusteredMesh& mesh, std::size_t points);

/// What the eye may see, in object space.
struct Visibility {
  std::vector<glm::vec4> planes = {};  ///< inward, normals unit: of the frustum
  std::vector<glm::vec4> cuts = {};    ///< those that cut, alike
  int group = -1;                      ///< the only one that is seen; -1: all
  bool skip_backs = false;             ///< leave out clusters that wholly face away, unless they are seen through an opening
  std::vector<glm::vec4> openings = {};  ///< spheres: center, radius
  bool orthographic = false;
  glm::vec3 eye{0};                    ///< where it is; orthographic: unit direction in which it looks
};

/// A cluster that may be seen.
struct SeenCluster {
  std::uint32_t cluster;
  bool backs;  ///< so may those of its triangles that face away
  bool cut;    ///< a plane may go through it
};
void visible_clusters(const ClusteredMesh& mesh, const Visibility& visibility, std::vector<SeenCluster>& seen);

/// Runs of neighboring triangles to draw.
struct Run {
  std::uint32_t first, count;
};
void runs_of(const ClusteredMesh& mesh, std::span<const SeenCluster> seen, std::vector<Run>& runs);
/// All triangles of a group, or of all if it is -1: one run, or none.
std::vector<Run> runs_of_group(const ClusteredMesh& mesh, int group);
