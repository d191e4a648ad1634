// Depth-dependent halos of surfaces. Everts, Bekker, Roerdink, Isenberg, IEEE TVCG 2009. A pixel is in the halo of a surface
// beside it that stands high enough over its tangent plane for its distance. Inputs: color, depth, normal. Output: color.
#include "lib/frame.glsl"

const int directions = 16;

// How wide the halo of what is seen at `uv` is where the surface (position, normal) is behind it, pixels.
float width_at(Properties p, vec2 uv, bool covered, vec3 position, vec3 normal) {
  float depth = depth_at(uv);
  if (isinf(depth) || any(greaterThan(abs(uv - 0.5), vec2(0.5)))) return 0.0;
  if (!covered) return p.width;
  return p.width * clamp(dot(normal, position_from(uv, depth) - position) / (p.full * lumen.extent.z), 0.0, 1.0);
}

vec4 render(Properties p, Pixel pixel) {
  vec4 scene = color_at(pixel.uv);
  float depth = depth_at(pixel.uv);
  bool covered = !isinf(depth);
  if (!covered && !p.background) return scene;
  vec3 position = covered ? position_from(pixel.uv, depth) : vec3(0), normal = normal_at(pixel.uv);
  float halo = 0.0;
  int reach = int(ceil(p.width));
  for (int i = 0; i < directions; ++i) {
    float angle = 6.2831853 * float(i) / float(directions);
    vec2 direction = vec2(cos(angle), sin(angle));
    for (int step = 1; step <= reach && halo < 1.0; ++step) {
      vec2 offset = round(direction * float(step));
      float width = width_at(p, pixel.uv + offset / lumen.size.xy, covered, position, normal);
      // The surface's edge is half a pixel on this side of its first pixel's center.
      if (width > 0.0) halo = max(halo, clamp(width + 1.0 - length(offset), 0.0, min(width, 1.0)));
    }
  }
  return mix(scene, vec4(p.color, 1), p.strength * halo);
}
