// Highlights around the halfway vector. Blinn, Models of Light Reflection for Computer Synthesized Pictures, SIGGRAPH 1977.
// Inputs: normal, eye, material, light. Output: radiance.
#include "lib/surface.glsl"

vec3 specular(Properties p, Surface s, Light l) {
  return s.specular_color * l.radiance * pow(max(dot(s.normal, normalize(l.direction + s.to_eye)), 0.0), s.shininess);
}
