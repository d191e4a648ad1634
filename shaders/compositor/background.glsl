// A color, a gradient or a picture behind the scene. Inputs: color, associated alpha. Output: opaque color.
#include "lib/frame.glsl"

vec3 picture_behind(Properties p, vec2 uv) {
  vec2 viewport = lumen.size.xy - 2.0 * lumen.size.z;
  vec2 scale = viewport / max(size_of(p.image), vec2(1));  // pixels per texel if the picture fills the view each way
  vec2 span = p.fit == 0 ? scale / max(scale.x, scale.y) : (p.fit == 1 ? scale / min(scale.x, scale.y) : vec2(1));
  vec2 at = ((uv * lumen.size.xy - lumen.size.z) / viewport - 0.5) * span + 0.5;
  vec4 texel = image(p.image, at);
  return any(greaterThan(abs(at - 0.5), vec2(0.5))) ? p.color : texel.rgb + (1.0 - texel.a) * p.color;
}

vec4 render(Properties p, Pixel pixel) {
  vec4 scene = color_at(pixel.uv);
  vec3 behind = p.color;
  if (p.mode == 1) behind = mix(p.bottom, p.color, pixel.uv.y);
  if (p.mode == 2 && given(p.image)) behind = picture_behind(p, pixel.uv);
  return vec4(scene.rgb + (1.0 - scene.a) * behind, 1);
}
