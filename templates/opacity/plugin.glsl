// Opacity that falls off with the distance to the eye. Inputs: position. Output: 0..1.
#include "lib/frame.glsl"
#include "lib/surface.glsl"

float opacity(Properties p, Surface s) {
  return p.alpha * mix(1.0, p.far_part, clamp(scene_depth(-s.position.z), 0.0, 1.0));
}
