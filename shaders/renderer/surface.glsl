// A triangle mesh, its normals averaged over the triangle, colored by an array if the renderer has one.
// Inputs: position, normal, value per vertex. Output: the surface in view space.
#include "lib/geometry.glsl"
#include "lib/surface.glsl"

#pragma stage vertex
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float value;

out vec3 view_position;
out vec3 view_normal;
out float shown_value;

void vertex(Properties p) {
  mat3 turn = mat3(p.transform);
  view_position = to_view(split((p.transform * vec4(position, 1)).xyz));
  view_normal = mat3(lumen.view) * split_direction(transform_normal(turn, normal));
  shown_value = value;
  gl_Position = project(view_position);
}

#pragma stage fragment
in vec3 view_position;
in vec3 view_normal;
in float shown_value;

layout(std430, binding = 8) readonly buffer Cells { uint cells[]; };  // which cell of the data each drawn triangle is

void surface(Properties p, inout Surface s) {
  s.position = view_position;
  // Where the data has no normal, the triangle's own stands in.
  s.normal = dot(view_normal, view_normal) > 0.0 ? normalize(view_normal) : normalize(cross(dFdx(view_position), dFdy(view_position)));
  if (p.colored) s.diffuse_color = map(p.color_map, shown_value).rgb;
  s.primitive = int(cells[primitive_number()]);
}
