// Dual depth peeling. Bavoil, Myers, Order Independent Transparency with Dual Depth Peeling, NVIDIA 2008.
// Inputs: lit fragments, extent = (-nearest, farthest) depth that is left. Outputs: colors in front and behind, under and
// over each other; the extent of what lies between; resolved: associated color.
#include "lib/blending.glsl"
#include "lib/surface.glsl"

layout(std430, binding = 10) buffer Left { uint left; };

void find(Properties p, Fragment f) { extent = vec4(-f.depth, f.depth, 0, 0); }

// The fragment's color if it is the nearest, or else the farthest, and where it goes; what was peeled before is discarded.
bool take(Fragment f, out vec4 nearest, out vec4 farthest) {
  vec2 range = texelFetch(extent, ivec2(gl_FragCoord.xy), 0).rg;
  if (f.depth < -range.x || f.depth > range.y) discard;
  vec4 color = vec4(f.color * f.alpha, f.alpha);
  bool is_nearest = f.depth == -range.x, is_farthest = !is_nearest && f.depth == range.y;
  nearest = is_nearest ? color : vec4(0);
  farthest = is_farthest ? color : vec4(0);
  return is_nearest || is_farthest;
}

void peel(Properties p, Fragment f) {
  bool taken = take(f, front, back);
  next_extent = taken ? vec4(uintBitsToFloat(0xFF800000u)) : vec4(-f.depth, f.depth, 0, 0);
  if (!taken) left = 1u;
}

void peel_last(Properties p, Fragment f) {
  bool taken = take(f, front, back);
  sum = taken ? vec4(0) : vec4(f.color * f.alpha, f.alpha) * normalized_weight(f.depth, p.decay);
  revealage = vec4(taken ? 0.0 : f.alpha);
  if (!taken) atomicAdd(left, 1u);
}

vec4 resolve(Properties p, Pixel pixel) { return over(front_at(pixel.uv), back_at(pixel.uv)); }

vec4 resolve_left(Properties p, Pixel pixel) {
  return over(front_at(pixel.uv), over(averaged(sum_at(pixel.uv), revealage_at(pixel.uv)), back_at(pixel.uv)));
}
