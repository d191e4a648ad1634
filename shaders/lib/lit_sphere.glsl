// Where a normal lies in the picture of a sphere. Sloan, Martin, Gooch, Gooch, The Lit Sphere, Graphics Interface 2001;
// light space after Todo, Anjyo, Yokoyama, Lit-Sphere Extension for Artistic Rendering, The Visual Computer 2013.
#include "lib/surface.glsl"
#include "lib/values.glsl"

// The choices of the properties `space`, `frame` and `*_mapping`, in their order.
const int lit_sphere_light_space = 0, lit_sphere_tangent_frame = 1, lit_sphere_equidistant = 1;

// v under the smallest rotation that takes unit a to unit b: two reflections. Opposite directions: half a turn about the
// camera's up, since every axis would do.
vec3 lit_sphere_turned(vec3 v, vec3 a, vec3 b) {
  vec3 middle = a + b;
  float square = dot(middle, middle);
  if (square < 1e-6) return vec3(-v.x, v.y, -v.z);
  v -= 2.0 * dot(v, a) * a;
  return v - 2.0 * dot(v, middle) / square * middle;
}

// The part of v across unit n, unit; `other` in its place where v runs along n.
vec3 lit_sphere_across(vec3 v, vec3 n, vec3 other) {
  vec3 across = v - dot(v, n) * n;
  float square = dot(across, across);
  return square < 1e-8 ? normalize(other - dot(other, n) * n) : across * inversesqrt(square);
}

// The normal as the picture's sphere has it: x right, y up, z out of the picture.
vec3 lit_sphere_normal(Surface s, Light l, int space, int frame) {
  if (space != lit_sphere_light_space) return s.normal;
  vec3 right, up;
  if (frame == lit_sphere_tangent_frame) {
    // The surface's tangent under the camera's up, laid across the light: twists where either runs along the other.
    vec3 tangent = lit_sphere_across(cross(vec3(0, 1, 0), s.normal), s.normal, vec3(1, 0, 0));
    right = lit_sphere_across(tangent, l.direction, vec3(0, 1, 0));
    up = cross(l.direction, right);
  } else {
    // The camera's axes, first square to the ray to the eye, which is the camera's own axis only without perspective.
    vec3 axis = vec3(0, 0, 1);
    right = lit_sphere_turned(lit_sphere_turned(vec3(1, 0, 0), axis, s.to_eye), s.to_eye, l.direction);
    up = lit_sphere_turned(lit_sphere_turned(vec3(0, 1, 0), axis, s.to_eye), s.to_eye, l.direction);
  }
  return vec3(dot(s.normal, right), dot(s.normal, up), dot(s.normal, l.direction));
}

// 0..1 from the bottom left. Orthographic: as a rendered sphere shows it. Equidistant: by the angle, half a turn across.
vec2 lit_sphere_uv(vec3 normal, int mapping) {
  if (mapping != lit_sphere_equidistant) return 0.5 * normal.xy + 0.5;
  float across = length(normal.xy);
  return 0.5 + normal.xy * (across > 0.0 ? atan(across, normal.z) / (3.14159265 * across) : 0.0);
}

// The picture's color for a normal; `dark` behind the picture's sphere and where the picture is clear.
vec3 lit_sphere_color(Image picture, int mapping, vec3 dark, vec3 normal) {
  if (normal.z < 0.0) return dark;
  vec4 texel = image(picture, lit_sphere_uv(normal, mapping));
  return texel.a > 0.0 ? texel.rgb / texel.a : dark;
}
