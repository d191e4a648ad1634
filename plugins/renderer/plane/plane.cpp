/// A cutting plane as a rectangle of set color, opacity and scale: where splitter.plane cuts. Schwankl, Splitting of Meshes in
/// Image-Space, Vienna 2013, section 4.1.

#include <glm/gtc/matrix_transform.hpp>
#include <lumen/gl/vertex_array.h>
#include <lumen/mesh.h>
#include <lumen/renderer.h>

namespace {

constexpr float margin = 1.1f;  // beyond the mesh, so that the frame is seen beside it

struct Plane : lumen::Renderer {
  explicit Plane(lumen::Binding& binding) : Renderer(binding) {
    style.ambient_color.set_default({0.08f, 0.1f, 0.13f});
    style.diffuse_color.set_default({0.3f, 0.5f, 0.75f});
  }

  lumen::Property<glm::vec3> translation{this, "translation", glm::vec3(0), {.unit = "world", .doc = "the middle of the rectangle; the mesh's center until it is set"}};
  lumen::Property<glm::vec3> axis{this, "axis", glm::vec3(0, 1, 0), {.min = -1, .max = 1, .doc = "what the normal, +z, is turned about"}};
  lumen::Property<float> angle{this, "angle", 0.0f, {.min = -180, .max = 180, .unit = "degrees", .doc = "how far the normal is turned"}};
  lumen::Property<glm::vec2> scale{this, "scale", glm::vec2(1), {.min = 0, .unit = "world", .doc = "half of each side; as large as the mesh, seen along the normal, until it is set"}};
  lumen::Input<lumen::Mesh> mesh{this, "mesh", {.doc = "what the rectangle fits while its middle or scale is not set; not drawn"}};
  lumen::Style style{this};
  lumen::Property<float> frame_width{this, "frame_width", 2.0f, {.min = 0, .max = 100, .unit = "pixels", .doc = "of the frame along the edges; 0: none", .group = "Frame"}};
  lumen::Property<lumen::Color> frame_color{this, "frame_color", lumen::Color(0.9f, 0.95f, 1), {.min = 0, .max = 1, .doc = "material color of the frame's diffuse term", .group = "Frame", .when = "frame_width"}};

  lumen::Bounds bounds() const override {
    const glm::vec3 half(scale.get(), 0);
    return lumen::Bounds{-half, half}.transformed(glm::translate(glm::mat4(1), translation.get()) * glm::mat4(turn()));
  }
  bool colors_itself() const override { return frame_width > 0; }

  void changed(std::string_view property) override {
    const auto fitted = mesh.get();
    if (fitted == nullptr || fitted->bounds().empty() || (property != "mesh" && property != "axis" && property != "angle")) return;
    const lumen::Bounds box = fitted->bounds();
    translation.set_default(box.center());
    const glm::mat3 axes = turn();
    const glm::vec3 half = 0.5f * margin * (box.max - box.min);
    scale.set_default({glm::dot(glm::abs(axes[0]), half), glm::dot(glm::abs(axes[1]), half)});
  }

  void draw(lumen::Draw& draw) override {
    if (!corners_) corners_ = lumen::gl::VertexArray::create();
    for (int part = 0; part < int(draw.parts().size()); ++part) {
      draw.use("renderer/plane.glsl", part);
      corners_.bind();
      glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    }
  }
  void released() override { corners_ = {}; }

 private:
  glm::mat3 turn() const {
    const glm::vec3 about = axis;
    return glm::length(about) > 0 ? glm::mat3(glm::rotate(glm::mat4(1), glm::radians(angle.get()), glm::normalize(about))) : glm::mat3(1);
  }

  lumen::gl::VertexArray corners_;  ///< without attributes: the shader knows the corners by their numbers
};

}  // namespace

LUMEN_PLUGIN(Plane, "renderer.plane", "A cutting plane as a rectangle of set color, opacity and scale. Schwankl, Splitting of Meshes in Image-Space, Vienna 2013.")
