// Colors on top of each other: associated (multiplied by their opacity), alpha last.
#include "lib/frame.glsl"

vec4 over(vec4 front, vec4 back) { return front + (1.0 - front.a) * back; }

// Weighted blending: what many layers look like together. Of their sum of (C a, a) w and prod(1 - a).
// McGuire, Bavoil, Weighted Blended Order-Independent Transparency, JCGT 2013.
vec4 averaged(vec4 sum, float revealage) { return vec4(sum.rgb / max(sum.a, 1e-30), 1.0) * (1.0 - revealage); }

// A weight that falls from 1 at the nearest to exp(-decay) at the farthest place of the transparent surfaces.
float normalized_weight(float depth, float decay) {
  vec2 extent = lumen.transparent_extent.xy;
  return exp(-decay * clamp((depth - extent.x) / (extent.y - extent.x), 0.0, 1.0));
}
