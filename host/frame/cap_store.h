/// The caps of split surfaces as the GL holds them, for as long as somebody else holds their shapes.
#pragma once

#include <map>
#include <memory>

#include <lumen/gl/vertex_array.h>
#include <lumen/mesh.h>

namespace lumenshop {

class CapStore {
 public:
  /// Draws the triangles with positions as attribute 0.
  void draw(const std::shared_ptr<const lumen::Mesh>& shape);

 private:
  struct Buffers {
    std::weak_ptr<const lumen::Mesh> shape;
    lumen::gl::Buffer positions, triangles;
    lumen::gl::VertexArray array;
  };
  std::map<const lumen::Mesh*, Buffers> held_;
};

}  // namespace lumenshop
