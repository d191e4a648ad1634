// The points of a surface as lit squares. Inputs: position, normal. Output: the surface in view space.
#include "lib/geometry.glsl"
#include "lib/surface.glsl"

#pragma stage vertex
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

out vec3 view_position;
out vec3 view_normal;

void vertex(Properties p) {
  view_position = to_view(split(position));
  view_normal = mat3(lumen.view) * split_direction(normal);
  gl_Position = project(view_position);
}

#pragma stage fragment
in vec3 view_position;
in vec3 view_normal;

void surface(Properties p, inout Surface s) {
  s.position = view_position;
  s.normal = normalize(view_normal);
  s.primitive = gl_PrimitiveID;
}
