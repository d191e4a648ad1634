// What lit spheres leave dark: each picture's darkest color where its light does not reach. Ostendorf 2021, section 4.
// Inputs: normal, eye, lights, pictures. Output: radiance without occlusion.
#include "lib/lights.glsl"
#include "lib/lit_sphere.glsl"

vec3 ambient(Properties p, Surface s) {
  if (!given(p.front) && !given(p.back)) return s.ambient_color;
  vec3 sum = vec3(0);
  for (int i = 0; i < lumen_light_count.x; ++i) {
    if (i == 0 ? !given(p.front) : !given(p.back)) continue;
    Light l = light_at(i, s.position);
    if ((p.space == lit_sphere_light_space ? dot(s.normal, l.direction) : s.normal.z) >= 0.0) continue;
    vec3 color = i == 0 ? p.front_dark : p.back_dark;
    if (p.use_material) color *= s.ambient_color;
    sum += p.use_light ? color * l.radiance : color;
  }
  return sum;
}
