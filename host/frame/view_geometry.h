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

/// The part of a picture that layers hold, and how densely they sample it.
struct PictureWindow {
  glm::ivec2 picture{0};    ///< pixels of the whole picture
  glm::ivec2 origin{0};     ///< of the part, in pixels of the picture from its bottom left; negative in a border
  glm::ivec2 size{0};       ///< of the part, in pixels of the picture
  int border = 0;           ///< pixels of the picture around the part
  int scale = 1;            ///< samples across a pixel of the picture: a layer's pixel is a sample
  glm::vec2 offset{0};      ///< how far all samples are moved, in pixels of the picture
};

/// Pixels of layers from `begin` up to `end`.
struct PixelBox {
  glm::ivec2 begin{0}, end{0};
  glm::ivec2 size() const { return end - begin; }
  bool empty() const { return begin.x >= end.x || begin.y >= end.y; }
};

/// The smallest box that holds both.
PixelBox united(const PixelBox& a, const PixelBox& b);

struct ViewGeometry {
  lumen::Camera camera;
  glm::ivec2 viewport{0};   ///< layers' pixels of the part
  int border = 0;           ///< layers' pixels around it
  glm::vec2 extent{0, 1};   ///< near and far of the scene's sphere along the axis
  float scene_radius = 1;
  PixelBox transparent;     ///< where transparent surfaces can be
  FrameBlock block;

  glm::ivec2 size() const { return viewport + 2 * border; }
  glm::mat4 world_to_clip() const { return block.projection * block.view; }
};

/// `drawn`: what the clip planes must hold.
ViewGeometry make_geometry(const lumen::Camera& camera, const PictureWindow& window, const lumen::Bounds& scene, const lumen::Bounds& drawn,
                           const lumen::Bounds& transparent, double time);

/// The pixels of the layers that the box can touch, and a margin for what is wider than its data.
PixelBox pixels_of(const ViewGeometry& geometry, const lumen::Bounds& box);

/// Sees all of the bounds from +z, with a margin: for views whose camera is missing.
lumen::Camera fitting_camera(const lumen::Bounds& scene, float aspect);

/// How far the 2 x 2 samples of a pixel are moved in round `index` of `rounds`: one round stays in the middle, four make a
/// rotated grid, so that no two of 16 samples share more than a column or a row.
glm::vec2 sample_offset(int index, int rounds);

}  // namespace lumenshop
