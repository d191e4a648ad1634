// A color or a gradient behind the picture. Inputs: color, associated alpha. Output: opaque color.
#include "lib/frame.glsl"

vec4 render(Properties p, Pixel pixel) {
  vec4 scene = color_at(pixel.uv);
  vec3 behind = p.mode == 0 ? p.color : mix(p.bottom, p.color, pixel.uv.y);
  return vec4(scene.rgb + (1.0 - scene.a) * behind, 1);
}
