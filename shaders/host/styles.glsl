// What each instance's surface is made of; the host adds lumen_style_of() and shade().
#include "lib/lights.glsl"

struct LumenStyle {
  ivec4 rows;           // of the values of its ambient, diffuse, specular and opacity term
  ivec4 variant;        // x: which combination of terms, y: whose style it is
  vec4 ambient_color;
  vec4 diffuse_color;
  vec4 specular_color;  // w: shininess
  vec4 unused[11];      // a row is 256 bytes long, so that it can be bound on its own
};

// The styles of all instances and of the insides that splitters open, and the one that a program which draws a single instance has bound.
layout(std430, binding = 1) readonly buffer LumenStyles { LumenStyle lumen_styles[]; };
layout(std140, binding = 12) uniform LumenOwnStyle { LumenStyle lumen_own_style; };

void lumen_take_material(LumenStyle style, inout Surface s) {
  s.ambient_color = style.ambient_color.rgb;
  s.diffuse_color = style.diffuse_color.rgb;
  s.specular_color = style.specular_color.rgb;
  s.shininess = style.specular_color.w;
}

// The material of s.style, whichever it is; of the instance that the program draws.
void lumen_material(inout Surface s) { lumen_take_material(lumen_styles[s.style], s); }
void lumen_own_material(inout Surface s) { lumen_take_material(lumen_own_style, s); }

// The normal turned toward the eye. `flat_normal` is the triangle's own, which faces the eye: where the averaged normal is on its
// side, it only leans over the silhouette, and turning it around would point it into the surface.
vec3 lumen_facing(vec3 normal, vec3 to_eye, vec3 flat_normal) {
  float facing = dot(normal, to_eye);
  if (facing >= 0.0) return normal;
  return dot(normal, flat_normal) < 0.0 ? -normal : normalize(normal - facing * to_eye);
}
