/// Lines where the depth or, for creases, the normal of the opaque scene jumps.
/// Saito, Takahashi, Comprehensible Rendering of 3-D Shapes, SIGGRAPH 1990; depth is compared across tangent planes.

#include <lumen/compositor.h>

namespace {

struct Silhouettes : lumen::Compositor {
  using Compositor::Compositor;

  lumen::Property<float> width{this, "width", 1.5f, {.min = 0, .max = 32, .unit = "pixels", .doc = "how wide a line is, centered on the edge"}};
  lumen::Property<lumen::Color> color{this, "color", {0, 0, 0}, {.min = 0, .max = 1, .doc = "of the lines"}};
  lumen::Property<float> opacity{this, "opacity", 1.0f, {.min = 0, .max = 1, .doc = "of the lines"}};
  lumen::Property<float> step{this, "step", 0.03f, {.min = 0.0001, .max = 2, .unit = "scene radii", .doc = "how far a neighbor must be off a surface's tangent plane to be another one", .logarithmic = true}};
  lumen::Property<bool> creases{this, "creases", false, {.doc = "lines where a surface bends sharply, too"}};
  lumen::Property<float> angle{this, "angle", 40.0f, {.min = 1, .max = 179, .unit = "degrees", .doc = "how far normals must turn from pixel to pixel to be a crease", .when = "creases"}};

  lumen::Reads depth{this, "depth"}, normal{this, "normal"};

  void render(lumen::Frame& frame) override {
    constexpr const char* shader = "compositor/silhouettes.glsl";
    const auto& edges = frame.scratch("edges", lumen::Format::RG8, frame.size());
    const auto& across = frame.scratch("across", lumen::Format::RG16F, frame.size());
    const auto& stairs = frame.scratch("stairs", lumen::Format::R8, frame.size());
    frame.fullscreen(shader, {.function = "edges_of", .target = &edges});
    frame.fullscreen(shader, {.function = "nearest_in_row", .target = &across, .inputs = {{"edges", &edges}}});
    frame.fullscreen(shader, {.function = "line_over", .target = &stairs, .inputs = {{"across", &across}}});
    frame.fullscreen(shader, {.inputs = {{"stairs", &stairs}}});
  }
};

}  // namespace

LUMEN_PLUGIN(Silhouettes, "compositor.silhouettes", "Lines where depth or normal jump. Saito, Takahashi, Comprehensible Rendering of 3-D Shapes, SIGGRAPH 1990.")
