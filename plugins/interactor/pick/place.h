/// A place of a mesh that was picked: which connected part it belongs to, and what the mesh's arrays say there.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <lumen/components.h>

namespace pick {

/// The innermost connected part that encloses a point, whichever way it is turned, by the solid angles of its triangles (van
/// Oosterom, Strackee, The Solid Angle of a Plane Triangle, IEEE Transactions on Biomedical Engineering 1983). -1: none does.
int part_around(const lumen::Mesh& mesh, const lumen::Grouping& parts, glm::vec3 point);

/// "name = value" of every array at a point (object space) of a source cell: arrays of points interpolated over the triangle,
/// those of cells as they are.
std::vector<std::string> values_at(const lumen::Mesh& mesh, int cell, glm::vec3 point);

}  // namespace pick
