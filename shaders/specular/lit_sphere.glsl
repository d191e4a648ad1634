// A highlight from the picture of a sphere, driven by one light. Todo et al., Lit-Sphere Extension, TVC 2013.
// Inputs: normal, eye, light, picture. Output: radiance.
#include "lib/lit_sphere.glsl"

vec3 specular(Properties p, Surface s, Light l) {
  if (l.index != p.light) return vec3(0);
  vec3 normal = lit_sphere_normal(s, l, p.space, p.frame);
  if (!given(p.highlight)) return s.specular_color * l.radiance * pow(max(normal.z, 0.0), s.shininess);
  vec3 color = lit_sphere_color(p.highlight, p.highlight_mapping, vec3(0), normal);
  if (p.use_material) color *= s.specular_color;
  return p.use_light ? color * l.radiance : color;
}
