// Diffuse light in four flat bands. Lake et al., Stylized Rendering Techniques for Scalable Real-Time 3D Animation, NPAR 2000;
// levels of Ostendorf 2021, eq. 3.8. Inputs: normal, material, light. Output: radiance.
#include "lib/surface.glsl"

float band(Properties p, float facing) {
  if (facing <= 0.0) return 0.0;
  if (facing >= p.thresholds.x) return p.levels.x;
  if (facing >= p.thresholds.y) return p.levels.y;
  return facing >= p.thresholds.z ? p.levels.z : p.levels.w;
}

vec3 diffuse(Properties p, Surface s, Light l) {
  float facing = dot(s.normal, l.direction);
  return s.diffuse_color * l.radiance * (band(p, facing) * (p.as_printed ? max(facing, 0.0) : 1.0));
}
