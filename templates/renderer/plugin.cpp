/// The points of a surface as lit squares.

#include <lumen/gl/vertex_array.h>
#include <lumen/mesh.h>
#include <lumen/renderer.h>

namespace {

struct @Class@ : lumen::Renderer {
  using Renderer::Renderer;

  lumen::Input<lumen::Mesh> mesh{this, "mesh", {.doc = "whose points are drawn; it needs normals"}};
  lumen::Property<float> size{this, "size", 3.0f, {.min = 1, .max = 64, .unit = "pixels", .doc = "side of a square"}};
  lumen::Style style{this};

  lumen::Bounds bounds() const override {
    const auto data = mesh.get();
    return data ? data->bounds() : lumen::Bounds{};
  }
  void changed(std::string_view property) override {
    if (property == "mesh") released();
  }
  void released() override { vertices_ = {}, positions_ = {}, normals_ = {}; }

  void draw(lumen::Draw& draw) override {
    const auto data = mesh.get();
    if (!data || data->positions.empty() || data->normals.empty()) return;
    if (!vertices_) {
      positions_ = lumen::gl::Buffer(std::as_bytes(data->positions.view()));
      normals_ = lumen::gl::Buffer(std::as_bytes(data->normals.view()));
      vertices_ = lumen::gl::VertexArray::create();
      vertices_.attribute(0, positions_, 3, sizeof(glm::vec3));
      vertices_.attribute(1, normals_, 3, sizeof(glm::vec3));
    }
    for (int part = 0; part < int(draw.parts().size()); ++part) {
      draw.use("renderer/@name@.glsl", part);
      vertices_.bind();
      glPointSize(size);
      glDrawArrays(GL_POINTS, 0, GLsizei(data->positions.size()));
    }
  }

 private:
  lumen::gl::VertexArray vertices_;
  lumen::gl::Buffer positions_, normals_;
};

}  // namespace

LUMEN_PLUGIN(@Class@, "renderer.@name@", "The points of a surface as lit squares.")
