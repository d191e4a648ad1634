// Fog by scene depth. Willis, Visual Simulation of Atmospheric Haze, CGF 1987; the curves of OpenGL 1.0, 1993.
// Inputs: color, depth, transparent. Output: color; alpha as it was.
#include "lib/frame.glsl"

// A pixel at a rim may hold some of a surface that does not reach its center: then the nearest surface beside it counts.
float depth_of(vec2 uv, float alpha) {
  float depth = depth_at(uv);
  if (!isinf(depth) || alpha >= 1.0) return depth;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) depth = min(depth, depth_at(uv + vec2(x, y) / lumen.size.xy));
  return depth;
}

float fog_at(Properties p, float depth) {
  if (isinf(depth)) return p.background ? 1.0 : 0.0;
  float behind = scene_depth(depth) - p.start;
  if (p.mode == 0) return p.end > p.start ? clamp(behind / (p.end - p.start), 0.0, 1.0) : step(0.0, behind);
  float thickness = p.density * max(behind, 0.0);
  return 1.0 - exp(p.mode == 1 ? -thickness : -thickness * thickness);
}

// Transparent surfaces have no depth here: what is behind them fades, they do not.
vec4 render(Properties p, Pixel pixel) {
  vec4 scene = color_at(pixel.uv), front = transparent_at(pixel.uv);
  vec4 behind = max(scene - front, 0.0);
  float fog = p.amount * fog_at(p, depth_of(pixel.uv, scene.a));
  return vec4(scene.rgb + fog * (p.color * behind.a - behind.rgb), scene.a);
}
