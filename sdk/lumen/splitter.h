/// Splitters: a surface in parts. Every draw honors them: opaque, transparent, picking, bounds, traced geometry.
#pragma once

#include <lumen/data.h>
#include <lumen/part.h>
#include <lumen/plugin.h>

namespace lumen {

class Splitter : public Plugin {
 public:
  using Plugin::Plugin;
  Kind kind() const override { return Kind::splitter; }
  /// The parts of a surface with these world bounds. Pure: depends on the properties alone.
  virtual std::vector<Part> parts(const Bounds& bounds) const = 0;
  /// Whether shaders/splitter/<name>.glsl has bool removed(Properties p, Surface s).
  virtual bool removes() const { return false; }
};

}  // namespace lumen
