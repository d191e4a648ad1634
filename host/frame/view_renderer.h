/// Draws one view: builds the passes from what the instances declare, runs those whose inputs changed, keeps the rest.
///
/// Thread: main, GL context current. One per view; programs and geometry are shared through the Composer.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include <lumen/camera.h>
#include <lumen/gl/texture.h>
#include <lumen/image.h>

#include "model/session.h"

namespace lumenshop {

class ShaderLibrary;

/// One pass of the last draw: for bench and the profile.
struct PassStatistics {
  std::string name;         ///< "geometry", "ssao", "lighting", "vignette" ...
  int runs = 0;             ///< since reset_statistics()
  double milliseconds = 0;  ///< of the last run; waited for when timing is on
  std::vector<double> samples;  ///< milliseconds of every run since reset_statistics(), while timing
};

class ViewRenderer {
 public:
  ViewRenderer(Session& session, ShaderLibrary& shaders, std::string view);
  ~ViewRenderer();

  /// Pixels of the picture, 1..16384 each. Keeps what it can.
  void resize(glm::ivec2 size);
  glm::ivec2 size() const;
  /// Layers beside the picture that shall be kept for layer(), by name.
  void request(const std::vector<std::string>& layers);

  /// Brings the picture up to date by at most one refinement. False if nothing had to run.
  bool draw();
  /// More refinements (antialiasing, progressive passes) are wanted: call draw() again while idle.
  bool unfinished() const;
  void finish();                              ///< draws until it is not
  /// While data is awaited: makes the layers that the first finish() fills, which takes as long as a pass.
  void prepare();
  float progress() const;                     ///< 0..1 of the refinements

  /// The finished picture, viewport only, linear with associated alpha.
  const lumen::gl::Texture& picture() const;
  /// A requested layer as float channels, rows top-down. Throws lumen::Error naming the layers there are.
  std::shared_ptr<lumen::Image> layer(const std::string& name);

  const lumen::Camera& camera() const;
  lumen::Bounds scene_bounds() const;
  /// What is under a pixel (origin top left): instance number, part, primitive (1..), 0 = background; its world position, and
  /// how the part was moved there.
  struct Hit { int instance = 0, part = 0, primitive = 0; glm::vec3 position{0}; glm::mat4 moved{1}; };
  /// `wanted`: which renderers; all if it is empty.
  Hit pick(glm::ivec2 pixel, const std::function<bool(const Instance& renderer)>& wanted = {});

  /// Draws with this occlusion or transparency in place of the view's own, or without this splitter; empty: the view as it is.
  void substitute(const std::string& instance);
  /// What an occlusion or transparency holds for this view: layers, scratch textures, buffers.
  std::size_t bytes_of(const Instance& instance) const;

  std::vector<PassStatistics> statistics() const;
  void reset_statistics();
  void set_timing(bool on);
  /// What could not be drawn, and shader errors.
  std::vector<lumen::Problem> problems() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lumenshop
