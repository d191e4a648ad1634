// Depth of field. Circle of confusion: Potmesil, Chakravarty, SIGGRAPH 1981. Each tap counts where its own circle would reach
// the pixel: what is in front covers, what is behind a sharp surface never gets onto it. Jimenez, SIGGRAPH 2014 courses.
// Inputs: color, depth, transparent. Output: color.
#include "lib/frame.glsl"

const float pi = 3.14159265;
const int tile = 8;  // pixels

float focal_distance(Properties p) {
  float focus = p.focus == 2 ? p.distance : pivot_at(vec2(0.5));
  if (p.focus == 1) {
    float there = depth_at((p.place * (lumen.size.xy - 2.0 * lumen.size.z) + lumen.size.z) / lumen.size.xy);
    if (!isinf(there)) focus = there;
  }
  return focus;
}

// Radius in pixels. The circle is A f |z - zf| / (z (zf - f)) on a sensor at f zf / (zf - f) behind the lens. A sensor that sees
// the camera's field of view there is as large as that distance says, so that in pixels f cancels. An orthographic view blurs
// as a perspective one that shows the focal plane as large: its lens looks from the camera's distance.
vec4 circle_of_confusion(Properties p, Pixel pixel) {
  float depth = depth_at(pixel.uv), focus = focal_distance(p);
  if (isinf(depth) && !p.background) {
    // Samples beside the center may have hit the surface next to it: such a rim blurs with the surface.
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) depth = min(depth, depth_at(pixel.uv + vec2(x, y) / lumen.size.xy));
    if (isinf(depth)) return vec4(0);
  }
  float lens = p.aperture * lumen.extent.z / max(focus, 1e-3 * lumen.extent.z);
  float diameter = isinf(depth) ? (orthographic() ? 1e6 * lens : pixels_of(lens, 1.0))
                                : pixels_of(lens * abs(depth - focus), max(depth, 1e-3 * lumen.extent.z));
  return vec4(min(0.5 * diameter, p.largest));
}

vec4 largest_in_tile(Properties p, Pixel pixel) {
  float largest = 0.0;
  for (int y = 0; y < tile; ++y)
    for (int x = 0; x < tile; ++x) largest = max(largest, circle_at((vec2(pixel.coordinate * tile + ivec2(x, y)) + 0.5) / lumen.size.xy));
  return vec4(largest);
}

// Of the tiles whose circles may reach this one.
vec4 largest_around(Properties p, Pixel pixel) {
  int far = int(p.largest) / tile + 1;
  float largest = 0.0;
  vec2 texel = 1.0 / vec2(textureSize(tile_largest, 0));
  for (int y = -far; y <= far; ++y)
    for (int x = -far; x <= far; ++x) {
      float there = tile_largest_at(pixel.uv + vec2(x, y) * texel);
      float gap = length(max(abs(vec2(x, y)) - 1.0, 0.0)) * float(tile);
      if (there >= gap) largest = max(largest, there);
    }
  return vec4(largest);
}

// What is seen behind the transparent surfaces, which have no depth here and stay sharp.
vec4 behind_at(vec2 uv) { return max(color_at(uv) - transparent_at(uv), 0.0); }

// How much of it is seen.
float clear_at(vec2 uv) { return max(1.0 - transparent_at(uv).a, 1e-4); }

vec4 render(Properties p, Pixel pixel) {
  const vec2 golden = vec2(-0.73736888, 0.67549029);  // cosine and sine of the golden angle
  vec4 scene = color_at(pixel.uv);
  float reach = circle_reach_at((vec2(pixel.coordinate) + 0.5) / float(tile) / vec2(textureSize(circle_reach, 0)));
  if (reach < 0.5) return scene;
  float radius = circle_at(pixel.uv), depth = depth_at(pixel.uv);
  reach += 0.5;  // where a circle's edge pixel still counts
  float nearer = isinf(depth) ? 1e30 : depth - 1e-3 * lumen.extent.z;
  bool before_focus = depth < focal_distance(p);
  float weights = 1.0 / max(pi * radius * radius, 1.0);
  vec4 sharp = behind_at(pixel.uv), own = sharp * weights, front = vec4(0);
  float clear = clear_at(pixel.uv), covered = 0.0, front_clear = 0.0;
  weights *= clear;
  int taps = clamp(int(5.0 * reach * reach), 8, p.samples);
  vec2 around = vec2(1, 0);
  for (int i = 0; i < taps; ++i) {
    // Denser near the center, where small circles count; `area` is what the tap stands for.
    float along = (float(i) + 0.5) / float(taps);
    vec2 offset = round(around * (reach * pow(along, 0.75)));
    float area = 1.5 * pi * reach * reach * sqrt(along) / float(taps);
    around = vec2(around.x * golden.x - around.y * golden.y, around.x * golden.y + around.y * golden.x);
    vec2 uv = pixel.uv + offset / lumen.size.xy;
    if (offset == vec2(0) || any(greaterThan(abs(uv - 0.5), vec2(0.5)))) continue;
    float circle = circle_at(uv);
    float there = depth_at(uv);
    bool in_front = there < nearer;
    // Before the focus, and at the scene's rim, what is behind shows through wherever the pixel's own circle spreads.
    if (!in_front) circle = before_focus || isinf(there) ? radius : min(circle, radius);
    float weight = area * clamp(circle - length(offset) + 0.5, 0.0, 1.0) / max(pi * circle * circle, 1.0);
    if (weight <= 0.0) continue;
    vec4 color = behind_at(uv) * weight;
    float seen = clear_at(uv) * weight;
    if (in_front) {
      front += color;
      covered += weight;
      front_clear += seen;
    } else {
      own += color;
      weights += seen;
    }
  }
  float over = min(covered, 1.0);
  vec4 blurred = over * front / max(front_clear, 1e-6) + (1.0 - over) * own / weights;
  return max(scene + clear * blurred - sharp, 0.0);
}
