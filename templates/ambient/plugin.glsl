// Ambient light, brighter from above. Inputs: normal, material. Output: radiance without occlusion.
#include "lib/frame.glsl"
#include "lib/surface.glsl"

vec3 ambient(Properties p, Surface s) {
  float up = dot(s.normal, mat3(lumen.view) * vec3(0, 1, 0));
  return s.ambient_color * mix(p.from_below, 1.0, 0.5 + 0.5 * up);
}
