// The outline of a cut volume and its handles, over the picture. Inputs: color; ink, what the lines cover and their dark margin.
// Output: color.
#include "lib/frame.glsl"

vec4 render(Properties p, Pixel pixel) {
  vec4 scene = color_at(pixel.uv);
  vec2 ink = ink_at(pixel.uv);
  scene = vec4(scene.rgb * (1.0 - ink.y), scene.a + (1.0 - scene.a) * ink.y);
  return mix(scene, vec4(1), ink.x);
}
