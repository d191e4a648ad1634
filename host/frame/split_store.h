/// What is slow to find where the splitters of a surface compose, for as long as it is used: groups of triangles that are common to
/// two of them, and the caps of single groups.
#pragma once

#include <map>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include <lumen/mesh.h>
#include <lumen/part.h>

namespace lumenshop {

using TriangleGroups = std::shared_ptr<const std::vector<std::uint32_t>>;

/// Triangles are together that are so in both groupings.
struct CommonGroups {
  TriangleGroups groups;
  std::map<std::pair<int, int>, int> number;  ///< of each pair of groups that has triangles
};

class SplitStore {
 public:
  /// Neither is null.
  const CommonGroups& common(const TriangleGroups& a, const TriangleGroups& b);

  /// What of a cap belongs to one group; null where the group's triangles have a border at the plane, or none lie there.
  struct GroupCap {
    std::shared_ptr<const lumen::Mesh> shape;
    bool closed = true;  ///< no border
  };
  /// `cap` is that of all triangles in `plane`.
  const GroupCap& cap(const lumen::Cap& cap, const glm::vec4& plane, const lumen::Mesh& mesh, const glm::mat4& object_to_world, const TriangleGroups& groups, int group);

  /// Lets go of what nobody has asked for since the last call.
  void forget_unused();

 private:
  struct Pair {
    CommonGroups common;
    TriangleGroups a, b;  ///< held, so that no others come to lie where they did
    bool used = true;
  };
  struct Made {
    GroupCap cap;
    std::shared_ptr<const lumen::Mesh> whole;
    TriangleGroups groups;
    bool used = true;
  };
  std::map<std::pair<const void*, const void*>, Pair> pairs_;
  std::map<std::tuple<const void*, const void*, int>, Made> caps_;
};

}  // namespace lumenshop
