/// Compositors: the picture becomes another picture. They run in the view's order.
#pragma once

#include <lumen/frame.h>
#include <lumen/plugin.h>

namespace lumen {

/// Reads the picture so far as layer `color` (linear, associated alpha) and writes it anew as `color`.
class Compositor : public Plugin {
 public:
  using Plugin::Plugin;
  Kind kind() const override { return Kind::compositor; }
  virtual void render(Frame& frame) = 0;

 protected:
  Reads color_in{this, "color"};
  Writes color_out{this, "color", Format::RGBA16F};
};

}  // namespace lumen
