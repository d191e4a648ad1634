/// Depth unsharp masking: the picture is darkened or brightened where the depth differs from its surroundings'.
/// Luft, Colditz, Deussen, Image Enhancement by Unsharp Masking the Depth Buffer, ACM TOG (SIGGRAPH) 2006.

#include <algorithm>

#include <glm/geometric.hpp>
#include <lumen/compositor.h>

namespace {

constexpr float fine = 4;  // texels that a standard deviation needs at least

struct DepthUnsharp : lumen::Compositor {
  using Compositor::Compositor;

  lumen::Property<float> strength{this, "strength", 0.4f, {.min = -10, .max = 10, .doc = "color per scene depth of difference; positive darkens what is behind an edge and brightens what is in front"}};
  lumen::Property<float> radius{this, "radius", 0.02f, {.min = 0.0005, .max = 0.25, .unit = "picture diagonals", .doc = "standard deviation of the Gaussian", .logarithmic = true}};
  lumen::Property<lumen::Choice> halos{this, "halos", {"both"}, {.doc = "which part of the difference is used", .choices = {"both", "dark", "bright"}}};

  lumen::Reads depth{this, "depth"};

  void render(lumen::Frame& frame) override {
    constexpr const char* shader = "compositor/depth_unsharp.glsl";
    const glm::vec2 size(frame.size());
    const float deviation = radius * glm::length(size - 2.0f * float(frame.border()));
    // A wide Gaussian needs no fine raster.
    const glm::ivec2 coarse(glm::clamp(glm::ceil(size * fine / deviation), glm::vec2(1), size));
    const auto& shrunk = frame.scratch("shrunk", lumen::Format::R32F, coarse);
    const auto& rows = frame.scratch("rows", lumen::Format::R32F, coarse);
    const auto& smooth_depth = frame.scratch("smooth_depth", lumen::Format::R32F, coarse);
    smooth_depth.linear();
    frame.fullscreen(shader, {.function = "shrink", .target = &shrunk});
    frame.fullscreen(shader, {.function = "blur_rows", .target = &rows, .inputs = {{"shrunk", &shrunk}}});
    frame.fullscreen(shader, {.function = "blur_columns", .target = &smooth_depth, .inputs = {{"rows", &rows}}});
    frame.fullscreen(shader, {.inputs = {{"smooth_depth", &smooth_depth}}});
  }
};

}  // namespace

LUMEN_PLUGIN(DepthUnsharp, "compositor.depth_unsharp", "Halos by depth unsharp masking. Luft, Colditz, Deussen, Image Enhancement by Unsharp Masking the Depth Buffer, SIGGRAPH 2006.")
