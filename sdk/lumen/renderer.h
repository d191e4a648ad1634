/// Renderers: data becomes layers.
///
/// The shader of a renderer has two parts, after lines `#pragma stage vertex` and `#pragma stage fragment`:
///   void vertex(Properties p)                     sets gl_Position, with split() and project() of lib/geometry.glsl
///   void surface(Properties p, inout Surface s)   fills in the surface at this fragment, or discards
/// The host adds what becomes of the fragment: layers, light, a transparency's store, an id.
#pragma once

#include <lumen/frame.h>
#include <lumen/plugin.h>

namespace lumen {

class Renderer : public Plugin {
 public:
  using Plugin::Plugin;
  Kind kind() const override { return Kind::renderer; }
  /// World; empty while there is nothing to draw.
  virtual Bounds bounds() const = 0;
  virtual void draw(Draw& draw) = 0;
  /// Whether surface() sets diffuse_color itself (colors by array), so that the albedo must be kept per pixel.
  virtual bool colors_itself() const { return false; }
};

/// The terms and the material of a surface: a member of each renderer that is lit.
struct Style {
  explicit Style(Plugin* owner);
  Property<Reference> ambient, diffuse, specular, opacity;
  Property<Color> ambient_color, diffuse_color, specular_color;
  Property<float> shininess;
};

}  // namespace lumen
