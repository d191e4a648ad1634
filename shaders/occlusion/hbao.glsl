// Ambient occlusion from the horizons around a pixel: the mean over directions of sin(horizon) - sin(tangent), both as elevations over
// the plane that faces the eye. Directions count by solid angle about the eye, not by the cosine to the normal: a crease of dihedral
// angle w seen along its bisector gets 1 - w / 180 degrees rather than (1 + cos w) / 2.
// Bavoil, Sainz, Dimitrov, Image-Space Horizon-Based Ambient Occlusion, SIGGRAPH 2008 talks.
// Inputs: depth, normal. Output: occlusion = 1 - visibility.
#include "lib/horizon.glsl"

// What one direction loses: each rise of the horizon counts by how near it is.
float lost(Properties p, Slice slice, Viewpoint at, float jitter) {
  float radius = p.radius * lumen.extent.z;
  float pixels = search_length(at, slice.direction, radius);
  float highest = sin(min(radians(p.bias) - slice.tilt, 1.57079633));
  float sum = 0.0;
  for (int i = 0; i < p.steps; ++i) {
    vec2 uv = search_uv(at, slice.direction, pixels, (float(i) + jitter) / float(p.steps));
    float stored = depth_at(uv);
    vec3 offset = position_from(uv, stored) - at.position;
    vec2 inside = in_slice(slice, at, offset);
    float elevation = inside.y * inversesqrt(max(dot(inside, inside), 1e-30));
    float share = dot(offset, offset) / (radius * radius);
    float weight = share > 1.0 ? 0.0 : (p.falloff ? 1.0 - share : 1.0);
    bool rises = found_at(uv, stored) && elevation > highest && weight > 0.0;
    sum += rises ? (elevation - highest) * weight : 0.0;
    highest = rises ? elevation : highest;
  }
  return sum;
}

vec4 gather(Properties p, Pixel pixel) {
  float refinement = refinement_at(vec2(0.5));
  vec2 uv = center_of(pixel.uv);
  float depth = depth_at(uv);
  if (isinf(depth)) return vec4(0, depth, 0, 1);
  Viewpoint at = viewpoint_at(uv, depth);
  vec2 noise = pattern_at(pixel.coordinate, refinement);
  float sum = 0.0;
  for (int i = 0; i < p.directions; ++i) sum += lost(p, slice_at(at, 6.2831853 * (float(i) + noise.x) / float(p.directions)), at, noise.y);
  return gathered(sum / float(p.directions), depth, refinement, before_at(pixel.uv));
}
