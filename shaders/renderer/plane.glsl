// A rectangle about a point, its normal +z turned about an axis, with a frame along its edges.
// Schwankl, Splitting of Meshes in Image-Space, Vienna 2013, section 4.1. Inputs: none per vertex. Output: the surface in view space.
#include "lib/geometry.glsl"
#include "lib/surface.glsl"

#pragma stage vertex
out vec2 place;  // -1..1 from edge to edge
out vec3 view_position;
flat out vec3 view_normal;

// v turned about an axis of any length, by degrees (Rodrigues).
vec3 turned(vec3 v, vec3 axis, float degrees) {
  if (dot(axis, axis) == 0.0) return v;
  vec3 about = normalize(axis);
  float c = cos(radians(degrees)), s = sin(radians(degrees));
  return c * v + s * cross(about, v) + (1.0 - c) * dot(about, v) * about;
}

void vertex(Properties p) {
  place = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  view_position = to_view(split(p.translation + turned(vec3(place * p.scale, 0), p.axis, p.angle)));
  view_normal = mat3(lumen.view) * split_direction(turned(vec3(0, 0, 1), p.axis, p.angle));
  gl_Position = project(view_position);
}

#pragma stage fragment
in vec2 place;
in vec3 view_position;
flat in vec3 view_normal;

void surface(Properties p, inout Surface s) {
  s.position = view_position;
  s.normal = normalize(view_normal);
  vec2 to_edge = (1.0 - abs(place)) / max(fwidth(place), 1e-20);
  if (min(to_edge.x, to_edge.y) < layer_pixels(p.frame_width)) s.diffuse_color = p.frame_color;
}
