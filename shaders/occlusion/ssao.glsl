// Ambient occlusion from a hemisphere of samples around the normal, dense near its center, turned per pixel.
// Mittring, Finding Next Gen: CryEngine 2, SIGGRAPH 2007 courses; Ostendorf 2021, section 3.7.
// Inputs: depth, normal. Output: occlusion = 1 - visibility.
#include "lib/occlusion.glsl"

// A view-space vector in pixels, homogeneous: linear, so that a sample costs one division.
vec3 in_pixels(vec3 v) {
  vec2 scale = lumen.size.xy / lumen.unproject.xy;
  return vec3(v.xy * scale, orthographic() ? 0.0 : -v.z);
}

vec4 gather(Properties p, Pixel pixel) {
  const vec2 golden = vec2(-0.73736888, 0.67549029);  // cosine and sine of the golden angle
  float refinement = refinement_at(vec2(0.5));
  vec2 uv = center_of(pixel.uv);
  float depth = depth_at(uv);
  if (isinf(depth)) return vec4(0, depth, 0, 1);
  float radius = p.radius * lumen.extent.z;
  vec3 position = position_from(uv, depth), normal = normal_at(uv);
  vec3 tangent = normalize(abs(normal.z) > 0.5 ? vec3(normal.z, 0, -normal.x) : vec3(-normal.y, normal.x, 0));
  vec3 bitangent = cross(normal, tangent);
  vec2 noise = pattern_at(pixel.coordinate, refinement);

  vec3 center = in_pixels(position) + vec3(0, 0, orthographic() ? 1 : 0);
  vec3 right = in_pixels(tangent * radius), up = in_pixels(bitangent * radius), out_of = in_pixels(normal * radius);
  vec2 origin = lumen.unproject.zw * lumen.size.xy / lumen.unproject.xy;
  // The sample slides to the pixel's center at its height over the surface, so that a plane never occludes itself: in
  // perspective its depth there is height / slope, orthographic (rise - height) / -slope.
  vec3 plane = vec3(normal.xy * lumen.unproject.xy / lumen.size.xy, dot(normal.xy, lumen.unproject.zw));
  vec2 kind = orthographic() ? vec2(0, 1) : vec2(1, 0);
  float steepest = orthographic() ? -1e-3 : -1e-4;
  float base = dot(normal, position), bias = p.bias * radius;
  float range = p.falloff ? 1.0 / radius : 0.0;

  vec2 around = vec2(cos(6.2831853 * noise.x), sin(6.2831853 * noise.x));
  float shift = fract(0.5 + 0.61803399 * refinement);
  float occluded = 0.0, seen = 0.0;
  for (int i = 0; i < p.samples; ++i) {
    float height = (float(i) + 0.5) / float(p.samples);
    float reach = fract(float(i) * 0.75487767 + shift);
    reach = 0.05 + 0.95 * reach * reach;
    vec2 side = around * (reach * sqrt(1.0 - height * height));
    around = vec2(around.x * golden.x - around.y * golden.y, around.x * golden.y + around.y * golden.x);
    vec3 at = center + right * side.x + up * side.y + out_of * (height * reach);
    vec2 place = floor(at.xy / at.z - origin) + 0.5;
    float inside = all(lessThan(abs(place - 0.5 * lumen.size.xy), 0.5 * lumen.size.xy)) ? 1.0 : 0.0;
    float stored = depth_at(place / lumen.size.xy);
    float rise = dot(plane, vec3(place, 1));
    float slope = min(rise * kind.x - normal.z, steepest);
    bool hidden = (stored + bias) * slope + rise * kind.y >= base + height * reach * radius;
    seen += inside;
    occluded += hidden ? inside * clamp(2.0 - (depth - stored) * range, 0.0, 1.0) : 0.0;
  }
  return gathered(occluded / max(seen, 1.0), depth, refinement, before_at(pixel.uv));
}
