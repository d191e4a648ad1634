// Warm where the surface faces the light, cool where it turns away. Gooch, Gooch, Shirley, Cohen, A Non-Photorealistic Lighting
// Model for Automatic Technical Illustration, SIGGRAPH 1998. Inputs: normal, material, light. Output: radiance.
#include "lib/surface.glsl"

vec3 diffuse(Properties p, Surface s, Light l) {
  vec3 cool = p.cool + p.alpha * s.diffuse_color;
  vec3 warm = p.warm + p.beta * s.diffuse_color;
  return l.radiance * mix(cool, warm, 0.5 + 0.5 * clamp(dot(s.normal, l.direction), -1.0, 1.0));
}
