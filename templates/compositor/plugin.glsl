// Tints the picture. Inputs: color. Output: color.
#include "lib/frame.glsl"

vec4 render(Properties p, Pixel pixel) {
  vec4 scene = color_at(pixel.uv);
  return vec4(scene.rgb * p.tint, scene.a);
}
