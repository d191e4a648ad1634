// Ambient occlusion from the horizons of slices through the eye's direction; the cosine-weighted integral over each is analytic.
// Jimenez, Wu, Pesce, Jarabo, Practical Realtime Strategies for Accurate Indirect Occlusion, SIGGRAPH 2016 courses.
// Inputs: depth, normal. Output: occlusion = 1 - visibility.
#include "lib/horizon.glsl"

// The cosine of the highest horizon on one side (+1, -1) of a slice; `lowest` is the tangent plane's.
float horizon(Properties p, Slice slice, Viewpoint at, float side, float lowest, float jitter) {
  float radius = p.radius * lumen.extent.z;
  vec2 direction = slice.direction * side;
  float pixels = search_length(at, direction, radius);
  float highest = lowest;
  for (int i = 0; i < p.steps; ++i) {
    vec2 uv = search_uv(at, direction, pixels, (float(i) + jitter) / float(p.steps));
    float stored = depth_at(uv);
    vec3 offset = position_from(uv, stored) - at.position;
    vec2 inside = in_slice(slice, at, offset);
    float cosine = inside.y * inversesqrt(max(dot(inside, inside), 1e-30));
    float weighted = mix(lowest, cosine, weight_of(length(offset), radius, p.falloff));
    highest = found_at(uv, stored) ? max(highest, weighted) : highest;
  }
  return highest;
}

vec4 gather(Properties p, Pixel pixel) {
  float refinement = refinement_at(vec2(0.5));
  vec2 uv = center_of(pixel.uv);
  float depth = depth_at(uv);
  if (isinf(depth)) return vec4(0, depth, 0, 1);
  Viewpoint at = viewpoint_at(uv, depth);
  vec2 noise = pattern_at(pixel.coordinate, refinement);
  float occluded = 0.0, open = 0.0;
  for (int i = 0; i < p.slices; ++i) {
    Slice slice = slice_at(at, 3.14159265 * (float(i) + noise.x) / float(p.slices));
    float lean = sin(slice.tilt);
    float left = horizon(p, slice, at, -1.0, lean, noise.y), right = horizon(p, slice, at, 1.0, -lean, noise.y);
    float whole = cosine_arc(slice, -acos(lean)) + cosine_arc(slice, acos(-lean));
    float visible = cosine_arc(slice, -acos(left)) + cosine_arc(slice, acos(right));
    occluded += slice.length * (whole - visible);
    open += slice.length * whole;
  }
  return gathered(occluded / open, depth, refinement, before_at(pixel.uv));
}
