/// Layers: named per-pixel results that instances write and read.
///
/// Declared as members, so that the host knows before drawing who needs what: it orders the passes, allocates only what
/// somebody reads, and runs a pass again only when something that it declared has changed.
///
/// The layers of every view (all of the opaque scene, except the last two):
///   depth     eye-space distance along the view axis, world units, background +inf   1 channel
///   normal    view space, facing the eye, unit; background 0                         3
///   position  view space, world units (an image of it, `--layer position`, holds world space)   3
///   albedo    linear diffuse color                                                   3
///   ambient, diffuse, specular   radiance                                            3
///   occlusion 1 - visibility                                                         1
///   id        R instance (1.. in session order), G part, B primitive; 0 = background 3
///   color     lit opaque scene, associated alpha = coverage                          4
///   transparent  associated color over the opaque scene                              4
///   opacity   1 - prod(1 - a) of the transparent surfaces                            1
/// Compositors and overlays read `color` as their predecessors left it, and beside these layers
///   opaque    the lit opaque scene, whatever compositors did to it                   4
///   front_depth, front_normal   depth and normal of the front-most surface, transparent ones included   1, 3
///
/// A declaration made or ended between two frames (a std::optional<Writes>, in changed()) counts from the next one on.
#pragma once

#include <cstddef>
#include <string>

namespace lumen {

class Plugin;

enum class Format { R8, RG8, RGBA8, R16F, RG16F, RGBA16F, R32F, RG32F, RGBA32F, R32UI, RG32UI, RGBA32UI, depth32F };

int channels_of(Format format);
std::size_t bytes_of(Format format);  ///< per pixel

/// The layer is there, complete, when the owner draws; shaders read it with NAME_at(uv).
class Reads {
 public:
  /// `border`: pixels beyond the viewport that the owner looks at.
  Reads(Plugin* owner, std::string layer, int border = 0);
  ~Reads();
  Reads(const Reads&) = delete;
  Reads& operator=(const Reads&) = delete;
  const std::string& layer() const { return layer_; }
  int border() const { return border_; }

 private:
  Plugin* owner_;
  std::string layer_;
  int border_;
};

/// The owner produces the layer; the host allocates it, viewport + the largest declared border.
class Writes {
 public:
  Writes(Plugin* owner, std::string layer, Format format);
  ~Writes();
  Writes(const Writes&) = delete;
  Writes& operator=(const Writes&) = delete;
  const std::string& layer() const { return layer_; }
  Format format() const { return format_; }

 private:
  Plugin* owner_;
  std::string layer_;
  Format format_;
};

}  // namespace lumen
