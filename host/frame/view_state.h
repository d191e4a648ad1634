/// The inside of a ViewRenderer.
#pragma once

#include <optional>
#include <set>

#include "frame/composite_pass.h"
#include "frame/light_block.h"
#include "frame/lighting_pass.h"
#include "frame/plugin_pass.h"
#include "frame/surface_pass.h"
#include "frame/view_renderer.h"

namespace lumenshop {

struct ViewRenderer::State {
  State(Session& session, ShaderLibrary& shaders, std::string view) : session(session), shaders(shaders), view(std::move(view)) {}

  Session& session;
  ShaderLibrary& shaders;
  std::string view;
  glm::ivec2 size{640, 480};
  std::set<std::string> requested;

  ViewScene scene;
  lumen::Camera camera;
  ViewGeometry geometry;            ///< of the centers
  ValueTable values;
  Shading shading;
  PassLog log;
  LayerStore centers, others;       ///< layers of the sample at the centers, which are kept; of the other samples
  lumen::gl::Buffer frame_block, light_block;
  std::map<std::string, PluginPassMemory> memories;
  std::vector<lumen::Problem> problems;

  LightBlock lights;
  int samples = 0;                  ///< in the picture so far
  std::uint64_t center_revision = 0;
  std::string picture = "lit";      ///< the layer of `centers` that is the picture
  lumen::gl::Texture cropped;       ///< the picture without its border
  std::uint64_t cropped_revision = 0;
  lumen::Bounds told_bounds;        ///< what interactors know
  float told_aspect = 0;
  std::set<lumen::Plugin*> told;    ///< compared, never called

  std::uint64_t drawn_session = 0, drawn_shaders = 0;  ///< revisions of the last draw
  bool stale = true;                ///< size or requests changed

  int samples_wanted() const { return scene.view == nullptr ? 1 : scene.view->antialiasing.get(); }
  bool progressive_unfinished() const;
  void find();
  void tell_interactors();
  FrameContext context(int set, const ViewGeometry& geometry, LayerStore& layers);
  /// Runs what is due up to the lit scene; the layer's name that holds it.
  std::string draw_scene(int set, glm::vec2 jitter, LayerStore& layers);
  void draw_sample();
  void draw_compositors(const std::string& scene_layer);
  int border() const;
  std::shared_ptr<lumen::Image> image_of(const std::string& name);
};

}  // namespace lumenshop
