// Ambient occlusion from a hemisphere of samples, each compared with the front surface of its pixel and with a random choice of those
// behind it. A surface hides what lies up to a thickness behind it: the next one may be farther back than the front one's shadow.
// Vermeer, Scandolo, Eisemann, Stochastic-Depth Ambient Occlusion, Proc. ACM Comput. Graph. Interact. Tech. 4(1) (I3D), 2021.
// Inputs: depth, normal; first, second, third, fourth = a drawing each; behind = the four in one. Output: occlusion = 1 - visibility.
#include "lib/hemisphere.glsl"

vec4 side_by_side(Properties p, Pixel pixel) {
  return vec4(first_at(pixel.uv), second_at(pixel.uv), third_at(pixel.uv), fourth_at(pixel.uv));
}

// The drawings' picture has the eye's axis in its middle, that of the layers need not (antialiasing moves its samples): how much more
// the tangent plane rises in the drawings' pixels than in the layers'.
float rise_of_drawings(Hemisphere h) {
  return dot(h.plane.xy, -0.5 * lumen.size.xy - h.origin);
}

// How much surfaces count at a sample: those it lies behind, by no more than the thickness.
vec4 counted(Hemisphere h, vec4 stored, float depth, float thickness) {
  vec4 beyond = depth - h.bias - stored;
  bvec4 hides = bvec4(uvec4(greaterThanEqual(beyond, vec4(0))) & uvec4(lessThanEqual(beyond, vec4(thickness))));
  return mix(vec4(0), nearness(h, stored), hides);
}

// Whether a sample is in the picture, and how much the occluder counts that counts most.
vec2 compared(Hemisphere h, vec3 at, float height, float more_rise, float thickness) {
  Tap tap = tap_at(h, at, height);
  vec4 front = counted(h, vec4(depth_at(tap.uv)), sample_depth(h, tap.rise, tap.height), thickness);
  vec4 most = max(front, counted(h, behind_at(tap.uv), sample_depth(h, tap.rise + more_rise, tap.height), thickness));
  return vec2(tap.inside, tap.inside * max(max(most.x, most.y), max(most.z, most.w)));
}

vec4 gather(Properties p, Pixel pixel) {
  float refinement = refinement_at(vec2(0.5));
  vec2 uv = center_of(pixel.uv);
  float depth = depth_at(uv);
  if (isinf(depth)) return vec4(0, depth, 0, 1);
  float radius = p.radius * lumen.extent.z;
  vec2 noise = pattern_at(pixel.coordinate, refinement);
  Hemisphere h = hemisphere_at(uv, depth, radius, p.bias * radius, p.falloff, noise.x);
  float more_rise = rise_of_drawings(h), thickness = p.thickness * radius;
  int pairs = (p.samples + 1) / 2;
  vec2 sum = vec2(0);
  for (int i = 0; i < pairs; ++i) {
    HemispherePair pair = pair_at(h, i, pairs, noise.y);
    sum += compared(h, pair.one, pair.height, more_rise, thickness) + compared(h, pair.other, pair.height, more_rise, thickness);
  }
  return gathered(sum.y / max(sum.x, 1.0), depth, refinement, before_at(pixel.uv));
}
