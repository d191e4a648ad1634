// Occlusion where the surface lies deeper than its surroundings. Luft, Colditz, Deussen, SIGGRAPH 2006.
// Inputs: depth. Output: occlusion = 1 - visibility.
#include "lib/frame.glsl"

vec4 render(Properties p, Pixel pixel) {
  float own = scene_depth(depth_at(pixel.uv)), deeper = 0.0;
  for (int i = 0; i < 16; ++i) {
    vec2 direction = vec2(cos(float(i) * 2.3999632), sin(float(i) * 2.3999632)) * sqrt((float(i) + 0.5) / 16.0);
    deeper += max(own - min(scene_depth(depth_at(pixel.uv + direction * p.radius / lumen.size.xy)), 1.0), 0.0);
  }
  return vec4(clamp(p.strength * deeper / 16.0, 0.0, 1.0));
}
