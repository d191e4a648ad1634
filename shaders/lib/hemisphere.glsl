// A hemisphere of samples around the normal, dense near its center, turned per pixel, in pairs on either side of the normal.
// Mittring, Finding Next Gen: CryEngine 2, SIGGRAPH 2007 courses; Ostendorf 2021, section 3.7.
#include "lib/occlusion.glsl"

// What all samples of a pixel have in common. Drivers compute in each round of a loop what stands in it, so nothing does that needn't.
struct Hemisphere {
  float radius, bias;
  vec3 center, right, up, out_of;  // in pixels
  float base;                      // height of the surface over the eye, along the normal
  vec2 turn;
  vec3 plane;        // dot(plane, (pixel, 1)): how far the tangent plane rises there
  vec2 kind;         // (1, 0) perspective, (0, 1) orthographic
  float steepest, facing;
  vec2 range;        // weight = x + stored * y
  vec2 origin, texel, middle;
};

struct HemispherePair {
  vec3 one, other;   // in pixels
  float height;      // over the eye, along the normal
};

// Where a sample is compared: at the center of its pixel, at its height over the surface.
struct Tap {
  vec2 uv;
  float inside;      // 1 in the picture, else 0
  float rise, height;
};

// A view-space vector in pixels, homogeneous: linear, so that a sample costs one division.
vec3 in_pixels(vec3 v) {
  vec2 scale = lumen.size.xy / lumen.unproject.xy;
  return vec3(v.xy * scale, orthographic() ? 0.0 : -v.z);
}

// `radius` and `bias` in world units.
Hemisphere hemisphere_at(vec2 uv, float depth, float radius, float bias, bool falloff, float turn) {
  vec3 position = position_from(uv, depth), normal = normal_at(uv);
  vec3 tangent = normalize(abs(normal.z) > 0.5 ? vec3(normal.z, 0, -normal.x) : vec3(-normal.y, normal.x, 0));
  bool flat_view = orthographic();
  Hemisphere h;
  h.radius = radius;
  h.bias = bias;
  h.center = in_pixels(position) + vec3(0, 0, flat_view ? 1 : 0);
  h.right = in_pixels(tangent * radius);
  h.up = in_pixels(cross(normal, tangent) * radius);
  h.out_of = in_pixels(normal * radius);
  h.base = dot(normal, position);
  h.turn = vec2(cos(6.2831853 * turn), sin(6.2831853 * turn));
  h.plane = vec3(normal.xy * lumen.unproject.xy / lumen.size.xy, dot(normal.xy, lumen.unproject.zw));
  h.kind = flat_view ? vec2(0, 1) : vec2(1, 0);
  h.steepest = flat_view ? -1e-3 : -1e-4;
  h.facing = normal.z;
  h.range = falloff ? vec2(2.0 - depth / radius, 1.0 / radius) : vec2(1, 0);
  h.origin = lumen.unproject.zw * lumen.size.xy / lumen.unproject.xy;
  h.texel = 1.0 / lumen.size.xy;
  h.middle = 0.5 * lumen.size.xy;
  return h;
}

// Pair `index` of `pairs`; to be asked for one after another. `shift` (0..1) moves all samples along their distances.
HemispherePair pair_at(inout Hemisphere h, int index, int pairs, float shift) {
  const vec2 golden = vec2(-0.73736888, 0.67549029);  // cosine and sine of the golden angle
  float height = (float(index) + 0.5) / float(pairs);
  float reach = fract(float(index) * 0.75487767 + shift);
  reach = 0.05 + 0.95 * reach * reach;
  vec2 side = h.turn * (reach * sqrt(1.0 - height * height));
  h.turn = vec2(h.turn.x * golden.x - h.turn.y * golden.y, h.turn.x * golden.y + h.turn.y * golden.x);
  height *= reach;
  vec3 lifted = h.center + h.out_of * height, aside = h.right * side.x + h.up * side.y;
  return HemispherePair(lifted + aside, lifted - aside, h.base + height * h.radius);
}

Tap tap_at(Hemisphere h, vec3 sample_in_pixels, float height) {
  vec2 place = floor(sample_in_pixels.xy / sample_in_pixels.z - h.origin) + 0.5;
  float inside = all(lessThan(abs(place - h.middle), h.middle)) ? 1.0 : 0.0;
  return Tap(place * h.texel, inside, dot(h.plane, vec3(place, 1)), height);
}

// The depth that a sample has there. It slid to the pixel's center at its height over the surface, so that a plane never occludes itself.
float sample_depth(Hemisphere h, float rise, float height) {
  float slope = min(rise * h.kind.x - h.facing, h.steepest);
  return (height - rise * h.kind.y) / slope;
}

// How much an occluder at a stored depth counts, by its distance from the pixel's surface along the view.
vec4 nearness(Hemisphere h, vec4 stored) { return clamp(h.range.x + stored * h.range.y, 0.0, 1.0); }
