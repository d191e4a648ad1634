// Ambient occlusion from a hemisphere of samples around the normal, compared with the stored depth.
// Mittring, Finding Next Gen: CryEngine 2, SIGGRAPH 2007 courses; Ostendorf 2021, section 3.7.
// Inputs: depth, normal. Output: occlusion = 1 - visibility.
#include "lib/hemisphere.glsl"

// Whether a sample is in the picture, and how much its occluder counts.
vec2 compared(Hemisphere h, vec3 at, float height) {
  Tap tap = tap_at(h, at, height);
  float stored = depth_at(tap.uv);
  bool hidden = stored + h.bias <= sample_depth(h, tap.rise, tap.height);
  return vec2(tap.inside, hidden ? tap.inside * nearness(h, vec4(stored)).x : 0.0);
}

vec4 gather(Properties p, Pixel pixel) {
  float refinement = refinement_at(vec2(0.5));
  vec2 uv = center_of(pixel.uv);
  float depth = depth_at(uv);
  if (isinf(depth)) return vec4(0, depth, 0, 1);
  float radius = p.radius * lumen.extent.z;
  vec2 noise = pattern_at(pixel.coordinate, refinement);
  Hemisphere h = hemisphere_at(uv, depth, radius, p.bias * radius, p.falloff, noise.x);
  int pairs = (p.samples + 1) / 2;
  vec2 sum = vec2(0);
  for (int i = 0; i < pairs; ++i) {
    HemispherePair pair = pair_at(h, i, pairs, noise.y);
    sum += compared(h, pair.one, pair.height) + compared(h, pair.other, pair.height);
  }
  return gathered(sum.y / max(sum.x, 1.0), depth, refinement, before_at(pixel.uv));
}
