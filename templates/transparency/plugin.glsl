// The mean color of all transparent layers, whatever their order. Bavoil, Myers, 2008.
// Inputs: lit fragments. Output: associated color.
#include "lib/frame.glsl"
#include "lib/surface.glsl"

void store(Properties p, Fragment f) {
  sum = vec4(f.color * f.alpha, f.alpha);
  revealage = vec4(f.alpha);
}

vec4 resolve(Properties p, Pixel pixel) {
  vec4 total = sum_at(pixel.uv);
  float opacity = 1.0 - revealage_at(pixel.uv);
  return vec4(p.gain * total.rgb / max(total.a, 1e-30) * opacity, opacity);
}
