/// The inside of a ViewRenderer.
#pragma once

#include <optional>
#include <set>

#include "frame/composite_pass.h"
#include "frame/light_block.h"
#include "frame/lighting_pass.h"
#include "frame/plugin_pass.h"
#include "frame/surface_draw.h"
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
  std::string substitute;           ///< see ViewRenderer::substitute

  ViewScene scene;
  lumen::Camera camera;
  ViewGeometry geometry;            ///< of the centers
  ViewGeometry main;                ///< of the picture without a border, for what splitters prepare
  ValueTable values;
  Shading shading;
  PassLog log;
  CapStore caps;
  SplitStore split_store;
  LayerStore centers, fine;         ///< layers at the pixels' centers, which are kept; of antialiasing's samples
  lumen::gl::Buffer frame_block, light_block;
  std::map<std::string, PluginPassMemory> memories;
  std::vector<lumen::Problem> problems;

  LightBlock lights;
  int samples = 0;                  ///< of a pixel in the picture so far: 1 = the center alone, else those of whole rounds
  std::uint64_t content_key = 0;    ///< what the samples show
  PixelBox scene_pixels;            ///< where they lie
  std::string picture = "lit";      ///< the layer of `centers` that is the picture
  lumen::gl::Texture cropped;       ///< the picture without its border
  std::uint64_t cropped_revision = 0;
  lumen::Bounds told_bounds;        ///< what interactors know
  float told_aspect = 0;
  std::set<lumen::Plugin*> told;    ///< compared, never called
  /// What splitters know: the bounds, and the generation of the object that was told.
  std::map<std::string, std::pair<lumen::Bounds, int>> told_splitters;

  std::uint64_t drawn_session = 0, drawn_shaders = 0;  ///< revisions of the last draw
  bool stale = true;                ///< size or requests changed

  static constexpr int samples_of_round = 4;  ///< antialiasing draws at twice the resolution
  int samples_wanted() const {
    const int samples = scene.view == nullptr ? 1 : scene.view->antialiasing.get();
    return samples <= 1 ? 1 : (samples + samples_of_round - 1) / samples_of_round * samples_of_round;
  }
  bool progressive_unfinished() const;
  void drop_fine();                 ///< the samples' layers, and what is known of their passes
  void forget_unused();             ///< what is no longer in the view must not count as unfinished
  bool unfinished() const { return stale || samples < samples_wanted() || progressive_unfinished(); }
  void find();
  void tell_interactors();
  bool tell_splitters();            ///< true if that changed values
  PictureWindow whole() const;
  ViewGeometry geometry_of(const PictureWindow& window) const;
  FrameContext context(int set, const PictureWindow& window, const ViewGeometry& geometry, LayerStore& layers);
  bool summands() const;            ///< the radiance is wanted term by term
  bool reads_front() const;         ///< somebody reads the front-most surface, transparent ones included
  bool needs_centers() const;       ///< somebody reads more than the mean of a pixel's samples
  bool draw(bool final);            ///< `final`: nobody looks before it is finished
  void prepare_splitters();         ///< if due, as all of these
  void draw_surfaces(const FrameContext& frame);
  void draw_occlusion(const FrameContext& frame);
  std::string light_scene(const FrameContext& frame);  ///< with transparency; the name of the layer that holds the lit scene
  void draw_picture(bool final);
  void prepare();
  /// Antialiasing without the picture of the centers: each surface is drawn once. The occlusion follows, since it serves all
  /// samples of a pixel: their mean is apart of what it attenuates.
  void draw_mean_alone();
  std::uint64_t opaque_key();
  struct SampleLayer {
    std::string name;
    lumen::Format format;
    float empty = 0;                ///< its first channel where no sample has been
  };
  std::vector<SampleLayer> sample_layers(bool apart) const;  ///< what the samples go to
  void begin_samples(bool apart);   ///< makes it empty
  void add_samples(bool apart);     ///< a round of antialiasing; `apart`: see LightingOutput
  void draw_compositors(const std::string& scene_layer);
  int border() const;
  std::shared_ptr<lumen::Image> image_of(const std::string& name);
  void world_position(glm::ivec2 pixel, float depth, const glm::mat4& to_world, float* position) const;
};

}  // namespace lumenshop
