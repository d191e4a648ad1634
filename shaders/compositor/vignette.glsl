// Fades the picture toward its corners: keeps 1 - smoothstep(r - s, r, |2 uv - 1|). Ostendorf 2021, section 4.
// Inputs: color. Output: color.
#include "lib/frame.glsl"

vec4 render(Properties p, Pixel pixel) {
  vec4 scene = color_at(pixel.uv);
  float keep = 1.0 - smoothstep(p.radius - p.softness, p.radius, length(2.0 * pixel.uv - 1.0));
  return vec4(mix(p.color * scene.a, scene.rgb, keep), scene.a);
}
