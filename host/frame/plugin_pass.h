/// Runs the drawing function of an occlusion, a transparency, a compositor or an overlay: what they see as Frame.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>

#include <lumen/frame.h>

#include "frame/frame_context.h"

namespace lumenshop {

/// What is remembered of an instance between its runs, to know when it must run again.
struct PluginPassMemory {
  std::set<std::string> files;   ///< shaders that its runs used
  bool uses_time = false, uses_lights = false, uses_geometry = false;
  bool unfinished = false;
  float progress = 0;            ///< while unfinished, 0..1
  int iteration = 0;
  std::uint64_t base_key = 0;    ///< of everything but the iteration
  lumen::TextureInputs inputs = {};  ///< of a splitter: what it drew for this view
  std::shared_ptr<const void> lead = {};  ///< see Instance::take_lead
};

/// Where a pass finds layers that stand under another name, and where it writes: layer name -> store name.
using LayerNames = std::map<std::string, std::string, std::less<>>;

class PluginPass final : public lumen::TransparencyFrame {
 public:
  /// `reads` and `writes` map what the plugin calls a layer to what the store calls it (a compositor's `color` is its
  /// predecessor's). `name` tells passes of one instance apart; default: its id.
  PluginPass(const FrameContext& context, Instance& instance, PluginPassMemory& memory, LayerNames reads, LayerNames writes, std::string name = {});

  /// Allocates what it writes and calls `draw` if anything that it declared has changed. True if it ran.
  bool run(const std::function<void(PluginPass&)>& draw);

  // lumen::Frame
  bool leads() const override;
  glm::ivec2 size() const override { return context_.geometry.size(); }
  int border() const override { return context_.geometry.border; }
  const lumen::Camera& camera() const override { return context_.geometry.camera; }
  float scene_radius() const override { return context_.geometry.scene_radius; }
  glm::vec2 extent() const override { return context_.geometry.extent; }
  double time() const override;
  glm::vec3 view_position(glm::ivec2 pixel, float depth) const override;
  std::vector<lumen::Light> lights() const override;
  std::vector<lumen::TracedSurface> traced_surfaces() const override;
  const lumen::gl::Texture& layer(const lumen::Reads& reads) const override;
  const lumen::gl::Texture& layer(const lumen::Writes& writes) const override;
  const lumen::gl::Texture& scratch(std::string_view name, lumen::Format format, glm::ivec2 size) override;
  void fullscreen(std::string_view shader, const lumen::FullscreenPass& pass) override;
  void draw_depth(const lumen::Camera& camera, const lumen::gl::Texture& depth, const lumen::DepthDraw& what) override;
  void parallel(int count, const std::function<void(int, int)>& body) const override;
  int iteration() const override { return memory_.iteration; }
  void unfinished(float progress) override {
    memory_.unfinished = true;
    memory_.progress = progress;
  }
  // lumen::TransparencyFrame
  void surfaces(std::string_view shader, const lumen::SurfacesPass& pass) override;

 private:
  std::uint64_t key() const;
  /// Calls it with `pixels_` set, and remembers what it has drawn.
  void draw_within(const std::function<void()>& draw);
  std::string stored(const LayerNames& names, const std::string& layer) const;
  std::string accessors() const;
  void use_file(const std::string& file);
  void bind_layers(Program& program) const;
  void write_surfaces_text(ProgramText& text, const std::string& file, const lumen::SurfacesPass& pass, const Instance& renderer) const;

  PixelBox& nonzero(const lumen::Writes& writes) const { return context_.layers.nonzero(stored(writes_, writes.layer())); }

  const FrameContext& context_;
  Instance& instance_;
  PluginPassMemory& memory_;
  LayerNames reads_, writes_;
  std::string name_;
  PixelBox pixels_;              ///< where it may draw into textures of the layers' size
};

}  // namespace lumenshop
