// Light that diffuses under a bent surface, as a function of N.L (Penner, Pre-Integrated Skin Shading, SIGGRAPH 2011 courses) and of
// a diffusion length in closed form; light from behind after Barre-Brisebois, Bouchard, Approximating Translucency for a Fast, Cheap
// and Convincing Subsurface Scattering Look, GDC 2011. Inputs: normal, eye, material, light. Output: radiance.
#include "lib/surface.glsl"

// The steady state of light that diffuses by the length s around a unit ring and is absorbed on the way, f - s^2 f'' = max(0, cos t):
// a cosine that is damped by 1 + s^2, and what flows over the terminator, which dies off exponentially on both sides of it. The ring's mean is kept.
vec3 diffused(vec3 s, float cosine) {
  const float pi = 3.14159265359;
  float from_terminator = abs(atan(cosine, sqrt(max(1.0 - cosine * cosine, 0.0))));
  vec3 flow = exp(-from_terminator / s) * (1.0 + exp((2.0 * from_terminator - pi) / s)) / (1.0 - exp(-pi / s));
  return (max(cosine, 0.0) + 0.5 * s * flow) / (1.0 + s * s);
}

vec3 diffuse(Properties p, Surface s, Light l) {
  float cosine = clamp(dot(s.normal, l.direction), -1.0, 1.0);
  vec3 bent = l.direction + p.distortion * s.normal;
  float straight = clamp(-dot(s.to_eye, bent) / max(length(bent), 1e-4), 0.0, 1.0);
  vec3 through = p.through * p.spread * pow(straight, p.sharpness);
  return s.diffuse_color * l.radiance * (diffused(max(p.width * p.spread, 1e-4), cosine) + through);
}
