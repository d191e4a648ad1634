// For removed() and cut_normal() of splitters: places in the view's own picture, whichever camera draws.
#include "lib/frame.glsl"
#include "lib/surface.glsl"

uniform mat4 lumen_main_view, lumen_eye_to_world;
uniform vec4 lumen_main_unproject;
uniform int lumen_main_orthographic;

// World position where a view-space position is drawn.
vec3 to_world(vec3 position) { return (lumen_eye_to_world * vec4(position, 1)).xyz; }

// Where the view's camera sees a world position: uv of what prepare() drew over its frame, and the eye distance along the axis.
vec3 main_place(vec3 world) {
  vec3 position = (lumen_main_view * vec4(world, 1)).xyz;
  vec2 plane = lumen_main_orthographic != 0 ? position.xy : position.xy / -position.z;
  return vec3((plane - lumen_main_unproject.zw) / lumen_main_unproject.xy, -position.z);
}
