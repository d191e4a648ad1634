/// Camera, scene and pixels of one sample of a frame, as matrices and as the block that shaders read.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <lumen/camera.h>
#include <lumen/data.h>

namespace lumenshop {

/// std140 block LumenFrame of shaders/lib/frame.glsl.
struct FrameBlock {
  glm::mat4 view{1}, projection{1};
  glm::vec4 unproject{0}, size{0}, extent{0}, transparent_extent{0};
};

struct ViewGeometry {
  lumen::Camera camera;
  glm::ivec2 viewport{0};   ///< pixels of the picture
  int border = 0;           ///< pixels around it
  glm::vec2 extent{0, 1};   ///< near and far of the scene's sphere along the axis
  float scene_radius = 1;
  FrameBlock block;

  glm::ivec2 size() const { return viewport + 2 * border; }
  glm::mat4 world_to_clip() const { return block.projection * block.view; }
};

/// `jitter`: where in its pixel the sample lies, -.5..+.5, 0 = the center. `drawn`: what the clip planes must hold.
ViewGeometry make_geometry(const lumen::Camera& camera, glm::ivec2 viewport, int border, glm::vec2 jitter, const lumen::Bounds& scene,
                           const lumen::Bounds& drawn, const lumen::Bounds& transparent, double time);

/// Sees all of the bounds from +z, with a margin: for views whose camera is missing.
lumen::Camera fitting_camera(const lumen::Bounds& scene, float aspect);

/// The place of sample `index` in its pixel: 0 is the center, the others fill the pixel evenly.
/// Roberts, The Unreasonable Effectiveness of Quasirandom Sequences, 2018 (R2).
glm::vec2 sample_offset(int index);

}  // namespace lumenshop
