// The front layer exact, the others by weighted sums. Everitt, Interactive Order-Independent Transparency, NVIDIA 2001;
// McGuire, Bavoil, Weighted Blended Order-Independent Transparency, JCGT 2013.
// Inputs: lit fragments, minus the depth of the nearest. Outputs: its color, sums of the others; resolved: associated color.
#include "lib/blending.glsl"
#include "lib/surface.glsl"

void find(Properties p, Fragment f) { nearest = vec4(-f.depth); }

void store(Properties p, Fragment f) {
  bool is_front = f.depth == -texelFetch(nearest, ivec2(gl_FragCoord.xy), 0).r;
  vec4 color = vec4(f.color * f.alpha, f.alpha);
  front = is_front ? color : vec4(0);
  sum = is_front ? vec4(0) : color * normalized_weight(f.depth, p.decay);
  revealage = vec4(is_front ? 0.0 : f.alpha);
}

vec4 resolve(Properties p, Pixel pixel) {
  return over(front_at(pixel.uv), averaged(sum_at(pixel.uv), revealage_at(pixel.uv)));
}
