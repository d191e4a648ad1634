// Opaque at the edge, clear in the middle. Ostendorf, Applications of Shading and Illumination Algorithms to Vascular 3D
// Meshes, Magdeburg 2021, eq. 3.38 with |N.V|. Inputs: normal, eye. Output: 0..1.
#include "lib/surface.glsl"

float opacity(Properties p, Surface s) {
  float facing = pow(min(abs(dot(s.normal, s.to_eye)), 1.0), p.falloff);
  return clamp(p.alpha_min + (p.alpha_max - p.alpha_min) * (1.0 - facing), 0.0, 1.0);
}
