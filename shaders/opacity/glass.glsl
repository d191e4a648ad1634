// Clear like glass, but for edges and highlights. Behrendt, Berg, Beuing, Preim, Saalfeld, Explorative Blood Flow Visualization Using
// Dynamic Line Filtering Based on Surface Features, CGF 2018. Inputs: position, normal, eye, the view's lights. Output: 0..1.
#include "lib/lights.glsl"
#include "lib/surface.glsl"

// The brightest channel of what all lights mirror toward the eye, as Blinn 1977 has it.
float highlight(Properties p, Surface s) {
  vec3 sum = vec3(0);
  for (int i = 0; i < lumen_light_count.x; ++i) {
    Light l = light_at(i, s.position);
    if (dot(s.normal, l.direction) > 0.0) sum += l.radiance * pow(max(dot(s.normal, normalize(l.direction + s.to_eye)), 0.0), p.shininess);
  }
  return max(sum.r, max(sum.g, sum.b));
}

float opacity(Properties p, Surface s) {
  float facing = pow(min(abs(dot(s.normal, s.to_eye)), 1.0), p.falloff);
  float edge = p.alpha_min + (p.alpha_max - p.alpha_min) * (1.0 - facing);
  return clamp(max(edge, p.highlights * highlight(p, s)), 0.0, 1.0);
}
