// Ambient occlusion in a grid of voxels: what the depth layer shows, with a thickness, sets bits; rays through the grid look for them.
// Penmatsa, Nichols, Wyman, Voxel-Space Ambient Occlusion, I3D 2010 posters; here each pixel sends cosine-weighted rays instead of
// adding up its neighbors' solid angles, which overlap. A column's bits: Eisemann, Decoret, Fast Scene Voxelization, I3D 2006.
// Inputs: depth, normal. Outputs: fill: four times 24 bits as whole numbers; gather: occlusion = 1 - visibility.
#include "lib/occlusion.glsl"

float slice_of(float depth) { return scene_depth(depth) * 96.0; }

// Bits first..last of 96, at most.
uvec4 run(int first, int last) {
  ivec4 channel = ivec4(0, 24, 48, 72);
  uvec4 below = uvec4(clamp(first - channel, 0, 24)), through = uvec4(clamp(last + 1 - channel, 0, 24));
  return ((uvec4(1) << through) - 1u) & ~((uvec4(1) << below) - 1u);
}

// A column: all pixels whose centers it holds.
vec4 fill(Properties p, Pixel pixel) {
  vec2 columns = round((vec2(pixel.coordinate) + 0.5) / pixel.uv);
  ivec2 first = ivec2(ceil(vec2(pixel.coordinate) / columns * lumen.size.xy - 0.501));
  ivec2 last = ivec2(ceil(vec2(pixel.coordinate + 1) / columns * lumen.size.xy - 0.501)) - 1;
  float thickness = p.thickness * lumen.extent.z;
  uvec4 bits = uvec4(0);
  for (int y = first.y; y <= last.y; ++y)
    for (int x = first.x; x <= last.x; ++x) {
      float depth = depth_at((vec2(x, y) + 0.5) / lumen.size.xy);
      if (!isinf(depth)) bits |= run(int(slice_of(depth)), int(min(slice_of(depth + thickness), 95.0)));
    }
  return vec4(bits);
}

// A ray's occlusion: how much the first filled voxel counts. Voxels that the tangent plane may cut hold the surface itself: they don't.
float blocked(Properties p, vec3 position, vec3 normal, vec3 direction, float jitter) {
  float radius = p.radius * lumen.extent.z, thickness = (lumen.extent.y - lumen.extent.x) / 96.0;
  vec2 column = abs(lumen.unproject.xy) / vec2(textureSize(voxels, 0));  // at depth 1 in perspective
  float result = 0.0;
  for (int i = 0; i < p.steps && result == 0.0; ++i) {
    float fraction = (float(i) + jitter) / float(p.steps);
    float range = radius * fraction * mix(fraction, 1.0, 0.5);
    vec3 at = position + direction * range;
    float depth = -at.z;
    vec2 uv = uv_of(at);
    vec3 sight = orthographic() ? vec3(0, 0, -1) : at / max(depth, 1e-20);
    float extent = dot(abs(normal.xy), column) * (orthographic() ? 1.0 : depth + thickness) + thickness * abs(dot(normal, sight));
    float slice = slice_of(depth);
    bool within = all(lessThan(abs(uv - 0.5), vec2(0.5))) && slice >= 0.0 && slice < 96.0 && (orthographic() || depth > 0.0);
    uvec4 bit = run(int(slice), int(slice));
    bool filled = any(notEqual(uvec4(voxels_at(uv)) & bit, uvec4(0)));
    result = within && filled && dot(normal, direction) * range > extent ? weight_of(range, radius, p.falloff) : 0.0;
  }
  return result;
}

vec4 gather(Properties p, Pixel pixel) {
  float refinement = refinement_at(vec2(0.5));
  vec2 uv = center_of(pixel.uv);
  float depth = depth_at(uv);
  if (isinf(depth)) return vec4(0, depth, 0, 1);
  vec3 position = position_from(uv, depth), normal = normal_at(uv);
  vec3 tangent = normalize(abs(normal.z) > 0.5 ? vec3(normal.z, 0, -normal.x) : vec3(-normal.y, normal.x, 0));
  vec3 bitangent = cross(normal, tangent);
  vec2 noise = pattern_at(pixel.coordinate, refinement);
  float sum = 0.0;
  for (int i = 0; i < p.rays; ++i) {
    float outward = (float(i) + noise.y) / float(p.rays), turn = 6.2831853 * fract(float(i) * 0.61803399 + noise.x);
    vec3 direction = (tangent * cos(turn) + bitangent * sin(turn)) * sqrt(outward) + normal * sqrt(1.0 - outward);
    sum += blocked(p, position, normal, direction, fract(noise.x * 4.0 + noise.y + float(i) * 0.38196601));
  }
  return gathered(sum / float(p.rays), depth, refinement, before_at(pixel.uv));
}
