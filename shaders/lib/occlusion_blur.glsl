// The mean of an occlusion over the 4x4 pixels that hold each value of its noise once, of those on the same surface: along
// rows, then along columns; and the same from half resolution up.
// Inputs: raw = sum of the refinements and depth; refinement = number of them before this one, one texel.
#include "lib/occlusion.glsl"

// Where a pixel's surface goes on to, and what deviation in depth still is the same surface.
struct Tangent {
  vec3 plane;   // depth or, in perspective, its reciprocal = dot(plane, (uv, 1))
  float depth, reach;
};

Tangent tangent_at(vec2 uv, float depth, float radius) {
  vec3 normal = normal_at(uv);
  vec2 slope = normal.xy * lumen.unproject.xy;
  float reach = min(radius, 0.05 * lumen.extent.z);
  if (orthographic()) {
    slope /= max(normal.z, 0.05);
    return Tangent(vec3(slope, depth - dot(slope, uv)), depth, reach);
  }
  vec2 ray = uv * lumen.unproject.xy + lumen.unproject.zw;
  slope /= -max(normal.z - dot(normal.xy, ray), 0.05) * depth;
  return Tangent(vec3(slope, 1.0 / depth - dot(slope, uv)), depth, reach);
}

// 0 on another surface, on none (where nothing was gathered, the depth is 0), or beyond the picture's edge.
float same_surface(Tangent tangent, vec2 uv, float depth) {
  float on_plane = dot(tangent.plane, vec3(uv, 1));
  float expected = orthographic() ? on_plane : 1.0 / max(on_plane, 1e-20);
  bool inside = all(lessThan(abs(uv - 0.5), vec2(0.5)));
  return inside && depth != 0.0 && min(abs(depth - expected), abs(depth - tangent.depth)) <= tangent.reach ? 1.0 : 0.0;
}

vec4 mean_along(Properties p, Pixel pixel, vec2 direction) {
  vec2 center = raw_at(pixel.uv);
  if (isinf(center.g)) return vec4(0, center.g, 0, 1);
  Tangent tangent = tangent_at(center_of(pixel.uv), center.g, p.radius * lumen.extent.z);
  vec2 texel = direction / vec2(textureSize(raw, 0));
  float sum = 0.0, weight = 0.0;
  for (int i = -2; i < 2; ++i) {
    vec2 uv = pixel.uv + float(i) * texel;
    vec2 tap = raw_at(uv);
    float same = i == 0 ? 1.0 : same_surface(tangent, uv, tap.g);
    sum += same * tap.r;
    weight += same;
  }
  return vec4(sum / weight, center.g, 0, 1);
}

vec4 rows(Properties p, Pixel pixel) { return mean_along(p, pixel, vec2(1, 0)); }
vec4 columns(Properties p, Pixel pixel) { return mean_along(p, pixel, vec2(0, 1)); }

// What is left to do once the sum is smooth.
vec4 finished(Properties p, float sum) {
  float visibility = 1.0 - clamp(sum / (refinement_at(vec2(0.5)) + 1.0), 0.0, 1.0);
  return vec4(1.0 - pow(visibility, p.strength));
}

vec4 rest(Properties p, Pixel pixel) { return finished(p, raw_at(pixel.uv).r); }
vec4 smooth_columns(Properties p, Pixel pixel) { return finished(p, columns(p, pixel).r); }

// Bilinear over the four nearest pixels of half resolution that lie on the pixel's own surface.
vec4 upsampled(Properties p, Pixel pixel) {
  Tangent tangent = tangent_at(pixel.uv, depth_at(pixel.uv), p.radius * lumen.extent.z);
  vec3 normal = normal_at(pixel.uv);
  vec2 size = vec2(textureSize(raw, 0));
  vec2 corner = floor(pixel.uv * size - 0.5);
  vec2 share = pixel.uv * size - 0.5 - corner;
  float sum = 0.0, weight = 0.0;
  for (int i = 0; i < 4; ++i) {
    vec2 step = vec2(i & 1, i >> 1);
    vec2 uv = (corner + step + 0.5) / size;
    vec2 tap = raw_at(uv);
    vec2 near = mix(1.0 - share, share, step);
    float same = same_surface(tangent, center_of(uv), tap.g) * smoothstep(0.5, 0.9, dot(normal, normal_at(center_of(uv))));
    same = (same + (tap.g == 0.0 || isinf(tap.g) ? 0.0 : 1e-4)) * (near.x * near.y + 1e-3);  // rather a neighbor than none
    sum += same * tap.r;
    weight += same;
  }
  return finished(p, weight > 0.0 ? sum / weight : 0.0);
}
