// Highlights with a hard edge. Lake et al., Stylized Rendering Techniques for Scalable Real-Time 3D Animation, NPAR 2000;
// Ostendorf 2021, eq. 3.9 with N.H. Inputs: normal, eye, material, light. Output: radiance.
#include "lib/surface.glsl"

vec3 specular(Properties p, Surface s, Light l) {
  float facing = dot(s.normal, normalize(l.direction + s.to_eye));
  return facing > p.threshold ? s.specular_color * l.radiance : vec3(0);
}
