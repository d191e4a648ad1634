/// A mesh cut by a plane, but for how far its halves move apart: what is slow to find, kept for as long as it holds.
#pragma once

#include <memory>
#include <vector>

#include <lumen/splitter.h>

struct PlaneCut {
  struct Asked {
    std::weak_ptr<const lumen::Mesh> mesh;
    glm::mat4 object_to_world{1};
    glm::vec4 plane{0};           ///< world, normal unit
    std::shared_ptr<const std::vector<std::uint32_t>> groups;  ///< of triangles: 0 is cut; null: all are
    bool capped = false;
    bool same(const Asked& other) const;
  };

  explicit PlaneCut(Asked asked);

  Asked asked;
  bool closed = false;                                       ///< no border of the mesh lies at the plane
  std::vector<glm::vec4> openings;                           ///< spheres around the cut's outlines, if closed
  std::shared_ptr<const lumen::Mesh> cap;                    ///< null: none
  int frames = 0;                                            ///< drawn since it came to be
};
