/// What the passes of one frame share.
#pragma once

#include <lumen/gl/buffer.h>

#include "frame/cap_store.h"
#include "frame/layer_store.h"
#include "frame/light_block.h"
#include "frame/pass_log.h"
#include "frame/shader_library.h"
#include "frame/shading.h"
#include "frame/value_table.h"
#include "frame/view_geometry.h"
#include "frame/view_scene.h"

namespace lumenshop {

struct FrameContext {
  Session& session;
  ShaderLibrary& shaders;
  ValueTable& values;
  Shading& shading;
  PassLog& log;
  CapStore& caps;
  LayerStore& layers;               ///< of this sample's set
  const LayerStore& centers;        ///< of the sample at the pixels' centers, whose occlusion serves all samples of a pixel
  const ViewScene& scene;
  const ViewGeometry& geometry;
  const ViewGeometry& main;         ///< of the view's own picture without a border, whatever this one shows
  const lumen::gl::Buffer& frame_block;
  const lumen::gl::Buffer& light_block;
  glm::vec4 to_centers;             ///< uv of the centers' layers = this set's uv * xy + zw
  std::uint64_t geometry_key;       ///< differs with camera, window and scene extent
  std::uint64_t light_key;          ///< differs with the lights
  LightKinds lights;
  int set;                          ///< 0: pixel centers; 1: antialiasing's samples, which are not kept

  /// The blocks and the value table, for a program that is about to draw.
  void bind(Program& program) const;
};

/// Draws the triangle of a full-screen pass with the current program.
void draw_fullscreen_triangle();

}  // namespace lumenshop
