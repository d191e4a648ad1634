// Light from pictures of spheres, one for the front light and one for all others. Sloan et al., The Lit Sphere, GI 2001;
// Todo et al., Lit-Sphere Extension, TVC 2013. Inputs: normal, eye, light, pictures. Output: radiance.
#include "lib/lit_sphere.glsl"

vec3 diffuse(Properties p, Surface s, Light l) {
  vec3 normal = lit_sphere_normal(s, l, p.space, p.frame);
  vec3 color;
  if (l.index == 0) {
    if (!given(p.front)) return s.diffuse_color * l.radiance * max(normal.z, 0.0);
    color = lit_sphere_color(p.front, p.front_mapping, p.fill_dark ? p.front_dark : vec3(0), normal);
  } else {
    if (!given(p.back)) return vec3(0);
    color = lit_sphere_color(p.back, p.back_mapping, p.fill_dark ? p.back_dark : vec3(0), normal);
  }
  if (p.use_material) color *= s.diffuse_color;
  return p.use_light ? color * l.radiance : color;
}
