// Diffuse light in steps. Lake, Marshall, Harris, Blackstein, NPAR 2000. Inputs: normal, material, light. Output: radiance.
#include "lib/surface.glsl"

vec3 diffuse(Properties p, Surface s, Light l) {
  float steps = float(p.steps);
  return s.diffuse_color * l.radiance * ceil(max(dot(s.normal, l.direction), 0.0) * steps) / steps;
}
