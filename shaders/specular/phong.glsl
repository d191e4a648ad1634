// Highlights around the mirrored light. Phong, Illumination for Computer Generated Pictures, CACM 1975.
// Inputs: normal, eye, material, light. Output: radiance.
#include "lib/surface.glsl"

vec3 specular(Properties p, Surface s, Light l) {
  return s.specular_color * l.radiance * pow(max(dot(reflect(-l.direction, s.normal), s.to_eye), 0.0), s.shininess);
}
