/// Splitters: a surface in parts. Every draw honors them: opaque, transparent, picking, bounds, traced geometry.
///
/// A splitter gives parts that planes cut and transforms move; it may also remove fragments, by functions of its shader
/// shaders/splitter/<name>.glsl, where s.place is the world position before any move and s.position the place in view space:
///   bool removed   (Properties p, Surface s)   asked where Part::removable
///   vec3 cut_normal(Properties p, Surface s)   of the cut's face through which an inside is seen: world, unit, toward the eye
/// A surface with several splitters is cut by all: its parts are the pairs of theirs, in the order of the splitters.
#pragma once

#include <lumen/camera.h>
#include <lumen/data.h>
#include <lumen/frame.h>
#include <lumen/part.h>
#include <lumen/plugin.h>

namespace lumen {

/// A surface before the cut.
struct SplitSurface {
  std::shared_ptr<const Mesh> mesh;  ///< null: not made of triangles
  glm::mat4 object_to_world{1};
  Bounds bounds;                     ///< world
  const Camera& camera;
};

/// How the inside looks where a splitter opens a surface: a member of each splitter that does.
///
/// Looks: none (as the outside), flat (the color as it is), lit (the terms, normals toward the eye), cut_surface (lit as the
/// face of the cut), cap (the cut is closed by its true face; where the mesh is open, as cut_surface).
struct Interior {
  explicit Interior(Plugin* owner, const char* look = "cap");
  Property<Choice> look;                          ///< id "interior"
  Property<Color> color, specular_color;          ///< "interior_color" is that of ambient and diffuse
  Property<float> shininess;
  Property<Reference> ambient, diffuse, specular; ///< terms; none: the surface's own
  bool caps() const { return look->name == "cap"; }
};

class Splitter : public Plugin {
 public:
  using Plugin::Plugin;
  Kind kind() const override { return Kind::splitter; }
  /// World bounds of all surfaces of the session that it cuts, as they are without it: the scale and the place for defaults.
  /// Called before a frame when they have changed, or the plugin was reloaded.
  virtual void surfaces_changed(const Bounds& bounds) { (void)bounds; }
  /// At least one part. Called for each surface before each frame that may differ: keep what is slow to find.
  virtual Split split(const SplitSurface& surface) = 0;
  /// Whether its shader has removed() and cut_normal().
  virtual bool removes() const { return false; }
  /// Draws what these read, as the view's camera sees it, before any surface; runs when something that it used has changed. The
  /// frame has no border and no layers.
  virtual void prepare(Frame& frame) { (void)frame; }
  /// What prepare() drew: NAME_at(uv) in removed() and cut_normal(), with uv = main_place(...).xy of lib/splitter.glsl.
  virtual TextureInputs inputs() const { return {}; }
};

}  // namespace lumen
