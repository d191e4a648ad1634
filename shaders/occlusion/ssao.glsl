// Ambient occlusion from a hemisphere of samples around the normal, dense near its center, turned per pixel.
// Mittring, Finding Next Gen: CryEngine 2, SIGGRAPH 2007 courses; Ostendorf 2021, section 3.7.
// Inputs: depth, normal. Output: occlusion = 1 - visibility.
#include "lib/occlusion.glsl"

// A view-space vector in pixels, homogeneous: linear, so that a sample costs one division.
vec3 in_pixels(vec3 v) {
  vec2 scale = lumen.size.xy / lumen.unproject.xy;
  return vec3(v.xy * scale, orthographic() ? 0.0 : -v.z);
}

// What all samples of a pixel are compared with.
struct Tap {
  vec3 plane;        // dot(plane, (pixel, 1)): how far the tangent plane rises there
  vec2 kind;         // (1, 0) perspective, (0, 1) orthographic
  float steepest, facing, bias;
  vec2 range;        // weight = x + stored * y
  vec2 origin, texel, middle;
};

// Whether a sample is in the picture, and how much its occluder counts. It slides to the pixel's center at its height over the surface, so
// that a plane never occludes itself: in perspective its depth there is height / slope, orthographic (rise - height) / -slope.
vec2 compared(Tap tap, vec3 at, float height) {
  vec2 place = floor(at.xy / at.z - tap.origin) + 0.5;
  float inside = all(lessThan(abs(place - tap.middle), tap.middle)) ? 1.0 : 0.0;
  float stored = depth_at(place * tap.texel);
  float rise = dot(tap.plane, vec3(place, 1));
  float slope = min(rise * tap.kind.x - tap.facing, tap.steepest);
  bool hidden = (stored + tap.bias) * slope + rise * tap.kind.y >= height;
  return vec2(inside, hidden ? inside * clamp(tap.range.x + stored * tap.range.y, 0.0, 1.0) : 0.0);
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

  // Drivers compute in each round of a loop what stands in it, so nothing does that needn't.
  bool flat_view = orthographic();
  Tap tap;
  tap.plane = vec3(normal.xy * lumen.unproject.xy / lumen.size.xy, dot(normal.xy, lumen.unproject.zw));
  tap.kind = flat_view ? vec2(0, 1) : vec2(1, 0);
  tap.steepest = flat_view ? -1e-3 : -1e-4;
  tap.facing = normal.z;
  tap.bias = p.bias * radius;
  tap.range = p.falloff ? vec2(2.0 - depth / radius, 1.0 / radius) : vec2(1, 0);
  tap.origin = lumen.unproject.zw * lumen.size.xy / lumen.unproject.xy;
  tap.texel = 1.0 / lumen.size.xy;
  tap.middle = 0.5 * lumen.size.xy;
  vec3 center = in_pixels(position) + vec3(0, 0, flat_view ? 1 : 0);
  vec3 right = in_pixels(tangent * radius), up = in_pixels(bitangent * radius), out_of = in_pixels(normal * radius);
  float base = dot(normal, position);

  vec2 around = vec2(cos(6.2831853 * noise.x), sin(6.2831853 * noise.x));
  int pairs = (p.samples + 1) / 2;
  vec2 sum = vec2(0);
  for (int i = 0; i < pairs; ++i) {
    float height = (float(i) + 0.5) / float(pairs);
    float reach = fract(float(i) * 0.75487767 + noise.y);
    reach = 0.05 + 0.95 * reach * reach;
    vec2 side = around * (reach * sqrt(1.0 - height * height));
    around = vec2(around.x * golden.x - around.y * golden.y, around.x * golden.y + around.y * golden.x);
    height *= reach;
    vec3 lifted = center + out_of * height, aside = right * side.x + up * side.y;
    float over = base + height * radius;
    sum += compared(tap, lifted + aside, over) + compared(tap, lifted - aside, over);
  }
  return gathered(sum.y / max(sum.x, 1.0), depth, refinement, before_at(pixel.uv));
}
