/// The statements of a Wavefront OBJ file, as it has them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <lumen/worker.h>

/// Indices as in a file but from 0, relative ones resolved; below 0: none. They may name what is not there.
struct ObjCorner {
  std::int64_t position = -1, coordinate = -1, normal = -1;
};

struct ObjText {
  std::vector<glm::vec3> positions, normals, colors;   ///< colors: one per position, or empty
  std::vector<glm::vec2> coordinates;
  /// The cells of one kind: the corners offsets[i] .. offsets[i + 1], the group and the material of each.
  struct Cells {
    std::vector<ObjCorner> corners;
    std::vector<std::uint32_t> offsets{0};
    std::vector<float> groups, materials;
  };
  Cells lines, polygons;
  std::size_t ill_formed = 0;                          ///< cells whose corners are no numbers
};

/// Throws lumen::Error with the file and line: a position that is no three numbers.
ObjText parse_obj(const std::string& path, lumen::WorkerProgress progress);
