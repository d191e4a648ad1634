// Ideal diffuse reflection. Lambert, Photometria, 1760. Inputs: normal, material, light. Output: radiance.
#include "lib/surface.glsl"

vec3 diffuse(Properties p, Surface s, Light l) { return s.diffuse_color * l.radiance * max(dot(s.normal, l.direction), 0.0); }
