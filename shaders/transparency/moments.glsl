// Moment-based transparency. Muenstermann, Krumpen, Klein, Peters, Moment-Based Order-Independent Transparency, I3D 2018.
// Inputs: lit fragments. Outputs: total absorbance and its moments of depth; then the sum of (C a, a) T and prod(1 - a), T the
// transmittance in front of the fragment by the moments; resolved: associated color.
#include "lib/blending.glsl"
#include "lib/surface.glsl"
#include "lib/moments.glsl"

// Opacity 1 would absorb infinitely much. What this lets through is seen in no color: the background is kept apart.
float absorbance_of(Fragment f) { return -log(1.0 - min(f.alpha, 0.9999)); }

// Depth as -1..1 over an extent: logarithmic as perspective is.
float warped(float depth, vec2 extent) {
  vec2 span = extent;
  float at = depth;
  if (!orthographic()) {
    span.x = max(span.x, span.y * 1e-4);
    at = log(max(at, span.x) / span.x);
    span = vec2(0.0, log(span.y / span.x));
  }
  return span.y > span.x ? clamp((at - span.x) / (span.y - span.x), 0.0, 1.0) * 2.0 - 1.0 : 0.0;
}

float z_in_surfaces(Fragment f) { return warped(f.depth, lumen.transparent_extent.xy); }
float z_in_pixel(Fragment f) { return warped(f.depth, texelFetch(extent, ivec2(gl_FragCoord.xy), 0).rg * vec2(-1, 1)); }

void find(Properties p, Fragment f) { extent = vec4(-f.depth, f.depth, 0, 0); }

vec4 absorb_low(float absorbance, float z) {
  total = vec4(absorbance);
  vec4 powers = vec4(z, z * z, z * z * z, z * z * z * z);
  low = absorbance * powers;
  return powers;
}
void absorb_4(Properties p, Fragment f) { absorb_low(absorbance_of(f), z_in_surfaces(f)); }
void absorb_4_in_pixel(Properties p, Fragment f) { absorb_low(absorbance_of(f), z_in_pixel(f)); }
void absorb_all(float absorbance, float z) {
  vec4 powers = absorb_low(absorbance, z);
  high = absorbance * powers.w * powers;
}
void absorb(Properties p, Fragment f) { absorb_all(absorbance_of(f), z_in_surfaces(f)); }
void absorb_in_pixel(Properties p, Fragment f) { absorb_all(absorbance_of(f), z_in_pixel(f)); }

void weigh_at(Properties p, Fragment f, float z, vec4 high_moments) {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float all = texelFetch(total, pixel, 0).r;
  float in_front = absorbed_before(p.moments + 2, texelFetch(low, pixel, 0) / all, high_moments / all, z, p.bias, p.overestimation);
  sum = vec4(f.color, 1.0) * f.alpha * exp(-all * in_front);
  revealage = vec4(f.alpha);
}
void weigh_4(Properties p, Fragment f) { weigh_at(p, f, z_in_surfaces(f), vec4(0)); }
void weigh_4_in_pixel(Properties p, Fragment f) { weigh_at(p, f, z_in_pixel(f), vec4(0)); }
void weigh(Properties p, Fragment f) { weigh_at(p, f, z_in_surfaces(f), texelFetch(high, ivec2(gl_FragCoord.xy), 0)); }
void weigh_in_pixel(Properties p, Fragment f) { weigh_at(p, f, z_in_pixel(f), texelFetch(high, ivec2(gl_FragCoord.xy), 0)); }

vec4 resolve(Properties p, Pixel pixel) { return averaged(sum_at(pixel.uv), revealage_at(pixel.uv)); }
