/// Transparency: the fragments of transparent surfaces become one color over the opaque scene.
#pragma once

#include <lumen/frame.h>
#include <lumen/plugin.h>

namespace lumen {

/// Writes the layer `transparent`: associated color, alpha = 1 - prod(1 - a).
class Transparency : public Plugin {
 public:
  using Plugin::Plugin;
  Kind kind() const override { return Kind::transparency; }
  virtual void render(TransparencyFrame& frame) = 0;
};

}  // namespace lumen
