// A triangle mesh, its normals averaged over the triangle, colored by an array if the renderer has one.
// Inputs: position, normal, value, curvature per vertex. Output: the surface in view space.
#include "lib/geometry.glsl"
#include "lib/surface.glsl"

#pragma stage vertex
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float value;
layout(location = 3) in vec3 curvature_squares;  // xx, yy, zz
layout(location = 4) in vec3 curvature_products; // xy, yz, zx

out vec3 view_position;
out vec3 view_normal;
out float shown_value;
out vec3 view_curvature_squares, view_curvature_products;

// The tensor of a surface that `matrix` moves, about the normal as it turns it. A surface f = 0 with the outward normal n bends by
// C = (Hessian of f) / |gradient of f|, and becomes f(A^-1 x) = 0: its C is A^-T C A^-1 / |A^-T n|, for any A.
mat3 transform_curvature(mat3 matrix, mat3 curvature, vec3 normal) {
  mat3 cofactors = mat3(cross(matrix[1], matrix[2]), cross(matrix[2], matrix[0]), cross(matrix[0], matrix[1]));
  float size = dot(matrix[0], cofactors[0]) * length(cofactors * normal);
  return size == 0.0 ? mat3(0) : cofactors * curvature * transpose(cofactors) / size;
}

void vertex(Properties p) {
  mat3 turn = mat3(p.transform);
  view_position = to_view(split((p.transform * vec4(position, 1)).xyz));
  view_normal = mat3(lumen.view) * split_direction(transform_normal(turn, normal));
  shown_value = value;
  if (p.curved) {
    vec3 squares = curvature_squares, products = curvature_products;
    mat3 tensor = mat3(squares.x, products.x, products.z, products.x, squares.y, products.y, products.z, products.y, squares.z);
    tensor = transform_curvature(mat3(lumen.view) * mat3(lumen_part) * turn, tensor, normal);
    view_curvature_squares = vec3(tensor[0][0], tensor[1][1], tensor[2][2]);
    view_curvature_products = vec3(tensor[0][1], tensor[1][2], tensor[2][0]);
  }
  gl_Position = project(view_position);
}

#pragma stage fragment
in vec3 view_position;
in vec3 view_normal;
in float shown_value;
in vec3 view_curvature_squares, view_curvature_products;

layout(std430, binding = 8) readonly buffer Cells { uint cells[]; };  // which cell of the data each drawn triangle is

void surface(Properties p, inout Surface s) {
  vec3 flat_normal = cross(dFdx(view_position), dFdy(view_position));  // faces the eye
  s.position = view_position;
  // Where the data has no normal, the triangle's own stands in.
  s.normal = dot(view_normal, view_normal) > 0.0 ? normalize(view_normal) : normalize(flat_normal);
  if (p.colored) s.diffuse_color = map(p.color_map, shown_value).rgb;
  if (p.curved) {
    vec3 squares = view_curvature_squares, products = view_curvature_products;
    // About the outside, which the mesh's normals may not face.
    float side = (dot(view_normal, flat_normal) >= 0.0) == s.front ? 1.0 : -1.0;
    s.curvature = side * mat3(squares.x, products.x, products.z, products.x, squares.y, products.y, products.z, products.y, squares.z);
  }
  s.primitive = int(cells[primitive_number()]);
}
