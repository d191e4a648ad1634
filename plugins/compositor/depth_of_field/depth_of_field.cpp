/// Depth of field: a thin lens blurs what is out of focus. Circle of confusion: Potmesil, Chakravarty, A Lens and Aperture
/// Camera Model for Synthetic Image Generation, SIGGRAPH 1981. Gathered as if scattered, what is in front over what is behind:
/// Jimenez, Next Generation Post Processing in Call of Duty: Advanced Warfare, SIGGRAPH 2014 courses. Transparent surfaces stay sharp.

#include <algorithm>
#include <cmath>

#include <lumen/compositor.h>

namespace {

constexpr int tile = 8;  // pixels, of depth_of_field.glsl

struct DepthOfField : lumen::Compositor {
  using Compositor::Compositor;

  lumen::Property<float> aperture{this, "aperture", 0.2f, {.min = 0, .max = 4, .unit = "scene radii", .doc = "diameter of the lens; 0 is a pinhole, all in focus"}};
  lumen::Property<lumen::Choice> focus{this, "focus", {"pivot"}, {.doc = "sharp is what the camera turns about, the surface at a place of the picture, or a distance", .choices = {"pivot", "place", "distance"}}};
  lumen::Property<glm::vec2> place{this, "place", glm::vec2(0.5f), {.min = 0, .max = 1, .doc = "of the picture, from its bottom left; the pivot while no opaque surface is there", .when = "focus = place"}};
  lumen::Property<float> distance{this, "distance", 1.0f, {.min = 1e-6, .max = 1e12, .unit = "world", .doc = "from the eye along the view axis", .when = "focus = distance", .logarithmic = true}};
  lumen::Property<bool> background{this, "background", false, {.doc = "what stands behind the scene blurs, too, as if infinitely far"}};
  lumen::Property<float> largest{this, "largest", 24.0f, {.min = 1, .max = 64, .unit = "pixels", .doc = "radius that no circle of confusion exceeds: larger ones cost more and show the samples"}};
  lumen::Property<int> samples{this, "samples", 96, {.min = 8, .max = 512, .doc = "taps where the largest circle reaches; fewer elsewhere", .constant = true}};

  lumen::Reads depth{this, "depth"}, transparent{this, "transparent"};

  void render(lumen::Frame& frame) override {
    constexpr const char* shader = "compositor/depth_of_field.glsl";
    const lumen::Camera& camera = frame.camera();
    const auto& pivot = frame.scratch("pivot", lumen::Format::R32F, {1, 1});
    const float pivot_depth = -(camera.view * glm::vec4(camera.pivot, 1)).z;
    pivot.upload(&pivot_depth);
    const auto& circle = frame.scratch("circle", lumen::Format::R32F, frame.size());
    const glm::ivec2 tiles = (frame.size() + tile - 1) / tile;
    const auto& tile_largest = frame.scratch("tile_largest", lumen::Format::R32F, tiles);
    const auto& circle_reach = frame.scratch("circle_reach", lumen::Format::R32F, tiles);
    frame.fullscreen(shader, {.function = "circle_of_confusion", .target = &circle, .inputs = {{"pivot", &pivot}}});
    frame.fullscreen(shader, {.function = "largest_in_tile", .target = &tile_largest, .inputs = {{"circle", &circle}}});
    frame.fullscreen(shader, {.function = "largest_around", .target = &circle_reach, .inputs = {{"tile_largest", &tile_largest}}});
    frame.fullscreen(shader, {.inputs = {{"pivot", &pivot}, {"circle", &circle}, {"circle_reach", &circle_reach}}});
  }
};

}  // namespace

LUMEN_PLUGIN(DepthOfField, "compositor.depth_of_field", "A lens blurs what is out of focus. Potmesil, Chakravarty, SIGGRAPH 1981; gathered after Jimenez, SIGGRAPH 2014 courses.")
