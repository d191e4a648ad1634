// Highlights of the mirrored light. Phong, CACM 1975. Inputs: normal, eye, material, light. Output: radiance.
#include "lib/surface.glsl"

vec3 specular(Properties p, Surface s, Light l) {
  float along = max(dot(reflect(-l.direction, s.normal), s.to_eye), 0.0);
  return p.strength * s.specular_color * l.radiance * pow(along, s.shininess);
}
