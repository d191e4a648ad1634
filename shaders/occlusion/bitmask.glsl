// Ambient occlusion from a mask of 32 sectors per slice: each sample covers those between its front and its back, which lies a
// thickness behind, so that light passes behind thin things. The sectors hold equal shares of cosine-weighted solid angle.
// Therrien, Levesque, Gilbert, Screen Space Indirect Lighting with Visibility Bitmask, The Visual Computer 2023.
// Inputs: depth, normal. Output: occlusion = 1 - visibility.
#include "lib/horizon.glsl"

// The share of a slice's sky, 0..1, on the far left of an angle. `left` and `whole`: the arcs from the eye to the left end, and of all.
float share_at(Slice slice, float angle, float left, float whole) {
  float clamped = clamp(angle, slice.tilt - 1.57079633, slice.tilt + 1.57079633);
  float arc = cosine_arc(slice, clamped);
  return clamp((left + (clamped < 0.0 ? -arc : arc)) / whole, 0.0, 1.0);
}

// Bits first..last-1.
uint sectors(int first, int last) {
  uint below_last = last > 31 ? ~0u : (1u << uint(last)) - 1u, below_first = first > 31 ? ~0u : (1u << uint(first)) - 1u;
  return below_last & ~below_first;
}

uint covered(Properties p, Slice slice, Viewpoint at, float side, float left, float whole, vec2 jitter) {
  float radius = p.radius * lumen.extent.z, thickness = p.thickness * lumen.extent.z;
  vec2 direction = slice.direction * side;
  float pixels = search_length(at, direction, radius);
  uint mask = 0u;
  for (int i = 0; i < p.steps; ++i) {
    vec2 uv = search_uv(at, direction, pixels, (float(i) + jitter.x) / float(p.steps));
    float stored = depth_at(uv);
    vec3 position = position_from(uv, stored), offset = position - at.position;
    vec2 front = in_slice(slice, at, offset), back = in_slice(slice, at, offset - to_eye(position) * thickness);
    float a = share_at(slice, atan(front.x, front.y), left, whole), b = share_at(slice, atan(back.x, back.y), left, whole);
    ivec2 ends = ivec2(vec2(min(a, b), max(a, b)) * 32.0 + jitter.y);
    bool counts = found_at(uv, stored) && weight_of(length(offset), radius, p.falloff) > jitter.y;  // a mask knows no halves: the noise decides
    mask |= counts ? sectors(ends.x, ends.y) : 0u;
  }
  return mask;
}

vec4 gather(Properties p, Pixel pixel) {
  float refinement = refinement_at(vec2(0.5));
  vec2 uv = center_of(pixel.uv);
  float depth = depth_at(uv);
  if (isinf(depth)) return vec4(0, depth, 0, 1);
  Viewpoint at = viewpoint_at(uv, depth);
  vec2 noise = pattern_at(pixel.coordinate, refinement);
  vec2 jitter = vec2(noise.y, fract(noise.x * 4.0 + noise.y));
  float occluded = 0.0, open = 0.0;
  for (int i = 0; i < p.slices; ++i) {
    Slice slice = slice_at(at, 3.14159265 * (float(i) + noise.x) / float(p.slices));
    float left = cosine_arc(slice, slice.tilt - 1.57079633), whole = left + cosine_arc(slice, slice.tilt + 1.57079633);
    uint mask = covered(p, slice, at, -1.0, left, whole, jitter) | covered(p, slice, at, 1.0, left, whole, jitter);
    occluded += slice.length * whole * float(bitCount(mask)) / 32.0;
    open += slice.length * whole;
  }
  return gathered(occluded / open, depth, refinement, before_at(pixel.uv));
}
