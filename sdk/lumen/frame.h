/// What a plugin sees of a frame while it draws.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <lumen/camera.h>
#include <lumen/gl/texture.h>
#include <lumen/layers.h>
#include <lumen/part.h>

namespace lumen {

struct Mesh;

/// How fragments meet what is in a target.
enum class Blend { replace, add, multiply_by_one_minus_source, over, under, maximum };

/// Where a pass writes one of its results.
struct Target {
  const gl::Texture* texture = nullptr;
  const char* name = "result";   ///< the shader's name for it
  Blend blend = Blend::replace;
  std::optional<glm::vec4> clear = {};  ///< what it holds before; default: what is in it
};

/// Textures that a pass reads: NAME_at(uv) in the shader, nearest; NAME as a sampler.
using TextureInputs = std::vector<std::pair<const char*, const gl::Texture*>>;

/// One full-screen pass; use designated initializers.
struct FullscreenPass {
  const char* function = "render";   ///< vec4 FUNCTION(Properties p, Pixel pixel) of the file
  const gl::Texture* target = nullptr;  ///< default: the first layer that the plugin writes
  TextureInputs inputs = {};
  bool covered_only = false;         ///< only where the opaque scene covers the pixel; elsewhere the target is 0
};

/// A surface as rays see it.
struct TracedSurface {
  std::shared_ptr<const Mesh> mesh;    ///< null: not for rays
  glm::mat4 object_to_world{1};
  Split split = {};                    ///< by its splitters, filled in by the host
  bool transparent = false;            ///< filled in by the host
  bool removes = false;                ///< shaders remove fragments, which rays meet all the same; filled in by the host
};

/// What Frame::draw_depth draws; use designated initializers.
struct DepthDraw {
  bool farthest = false;   ///< the farthest surface of each pixel, not the nearest; then -inf where there is nothing
  bool closed = false;     ///< parts uncut and unmoved
  float share = 1;         ///< the chance of each fragment to be drawn, 0..1: below 1, a sample of what lies behind one another
  int sample = 0;          ///< which sample: each has chances of its own
  /// Which parts; default: all. Called with the renderer's id.
  std::function<bool(const std::string& renderer, const Part& part)> wanted = {};
};

/// One view being drawn. Valid during the call that it is given to; the GL context is current.
class Frame {
 public:
  virtual ~Frame() = default;
  /// Whether this view leads, of all that draw the instance: the one in which a value is found that serves them all.
  virtual bool leads() const = 0;
  virtual glm::ivec2 size() const = 0;       ///< pixels of the layers, border included
  virtual int border() const = 0;            ///< pixels around the viewport
  virtual const Camera& camera() const = 0;
  virtual float scene_radius() const = 0;    ///< world, of the bounding sphere
  virtual glm::vec2 extent() const = 0;      ///< near and far of the bounding sphere along the view axis, world, eye distance
  virtual double time() const = 0;           ///< seconds
  /// View-space position of what a pixel of the layers (origin bottom left) shows at an eye distance along the axis.
  virtual glm::vec3 view_position(glm::ivec2 pixel, float depth) const = 0;
  virtual std::vector<Light> lights() const = 0;  ///< front first; shaders have them through lib/lights.glsl
  /// What rays can hit, on the screen or not.
  virtual std::vector<TracedSurface> traced_surfaces() const = 0;

  virtual const gl::Texture& layer(const Reads& reads) const = 0;
  virtual const gl::Texture& layer(const Writes& writes) const = 0;
  /// A texture of the caller's own, kept from frame to frame while format and size stay.
  virtual const gl::Texture& scratch(std::string_view name, Format format, glm::ivec2 size) = 0;

  /// Draws the shader ("occlusion/ssao.glsl", found as plugins' files are) over the target.
  virtual void fullscreen(std::string_view shader, const FullscreenPass& pass = {}) = 0;

  /// The opaque surfaces as another camera sees them: fills `depth` (R32F) with eye distances along its axis, world
  /// units, +inf where there is nothing. For shadows and cutaways.
  virtual void draw_depth(const Camera& camera, const gl::Texture& depth, const DepthDraw& what = {}) = 0;

  /// Calls body(first, last) for parts of 0..count on all cores, and returns when all are done. It may throw.
  virtual void parallel(int count, const std::function<void(int first, int last)>& body) const = 0;

  /// Which refinement this is, 0..; and that another one is wanted while idle.
  virtual int iteration() const = 0;
  virtual void unfinished(float progress = 0) = 0;  ///< how far this one is, 0..1
};

/// One drawing of the transparent surfaces; use designated initializers.
struct SurfacesPass {
  const char* function = "store";    ///< void FUNCTION(Properties p, Fragment fragment) of the file; writes the targets by name
  std::vector<Target> targets = {};  ///< none: the function writes storage of the plugin's own
  TextureInputs inputs = {};
  bool lit = true;                   ///< whether fragment.color is wanted: lighting costs more than the rest
};

/// The transparent part of a frame: on top of Frame, it draws all transparent surfaces.
///
/// Storage buffers 10 to 15 and image units 0 to 7 belong to the plugin, which binds them itself before a pass; what one
/// pass stored there the next one sees. Where no transparent surface is, nothing is drawn: passes cover the box of pixels
/// around them alone, full-screen ones too, and targets of the layers' size are cleared there.
class TransparencyFrame : public Frame {
 public:
  /// Draws every transparent surface once: each fragment in front of the opaque scene, in no order.
  virtual void surfaces(std::string_view shader, const SurfacesPass& pass) = 0;
};

/// What a renderer draws into: the host decides which pass it is and what comes of the fragments.
class Draw {
 public:
  virtual ~Draw() = default;
  virtual const Camera& camera() const = 0;
  virtual const glm::mat4& world_to_clip() const = 0;
  virtual glm::ivec2 size() const = 0;
  /// Which triangles that face away can be seen, if the surface is closed: none, those behind a hole that a plane of the
  /// part cuts (Part::openings), or any.
  enum class Backs { hidden, behind_openings, anywhere };
  virtual Backs backs(int part) const = 0;
  /// Primitives are told apart by gl_PrimitiveID: draw all in one call, in the order of the data that the shader expects.
  virtual bool identifies() const = 0;
  /// The parts to draw, one by one; one untouched part if there is no splitter. A part may have a group.
  virtual std::span<const Part> parts() const = 0;
  /// The group of each triangle of the mesh; null: parts have none.
  virtual const std::shared_ptr<const std::vector<std::uint32_t>>& groups() const = 0;
  /// Makes the shader's program current for part `index`, with the instance's properties. Textures from `inputs` are bound.
  virtual void use(std::string_view shader, int part, std::span<const std::pair<const char*, const gl::Texture*>> inputs = {}) = 0;
  /// What primitive_number() of the shader begins with in the next call that draws; 0 after use().
  virtual void number_from(int first) = 0;
};

}  // namespace lumen
