/// Occlusion: layers become occlusion (1 - visibility) or illumination.
#pragma once

#include <lumen/frame.h>
#include <lumen/plugin.h>

namespace lumen {

/// What the visibility multiplies.
enum class Attenuates { ambient, ambient_and_diffuse, everything };

/// Writes the layer `occlusion` (1 channel) or `illumination` (3 channels).
class Occlusion : public Plugin {
 public:
  using Plugin::Plugin;
  Kind kind() const override { return Kind::occlusion; }
  virtual Attenuates attenuates() const { return Attenuates::ambient; }
  virtual void render(Frame& frame) = 0;
};

}  // namespace lumen
