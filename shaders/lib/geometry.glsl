// For vertex functions of renderers: the part of a splitter, and the projection.
#include "lib/frame.glsl"

uniform mat4 lumen_part;  // world to world, after the cut

// A world position of the part, moved. Call once per vertex: it also cuts.
vec3 split(vec3 world) {
  lumen_cut(world);
  return (lumen_part * vec4(world, 1)).xyz;
}

// A world direction of the part, turned.
vec3 split_direction(vec3 world) { return mat3(lumen_part) * world; }

vec3 to_view(vec3 world) { return (lumen.view * vec4(world, 1)).xyz; }

vec4 project(vec3 position) { return lumen.projection * vec4(position, 1); }

// What turns normals as `matrix` turns positions: the cofactors, right under any scale; not unit.
vec3 transform_normal(mat3 matrix, vec3 normal) {
  return cross(matrix[1], matrix[2]) * normal.x + cross(matrix[2], matrix[0]) * normal.y + cross(matrix[0], matrix[1]) * normal.z;
}
