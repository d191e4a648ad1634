// What each instance's surface is made of; the host fills the table and adds shade().
#include "lib/lights.glsl"

struct LumenStyle {
  ivec4 rows;           // of the values of its ambient, diffuse, specular and opacity term
  ivec4 variant;        // x: which combination of terms
  vec4 ambient_color;
  vec4 diffuse_color;
  vec4 specular_color;  // w: shininess
};

layout(std430, binding = 1) readonly buffer LumenStyles { LumenStyle lumen_styles[]; };

// The material of s.instance, where the surface has none of its own.
void lumen_material(inout Surface s) {
  LumenStyle style = lumen_styles[s.instance];
  s.ambient_color = style.ambient_color.rgb;
  s.diffuse_color = style.diffuse_color.rgb;
  s.specular_color = style.specular_color.rgb;
  s.shininess = style.specular_color.w;
}
