// A plane's handle: a disk in the plane, an arrow along its normal, a ring about each of its axes; what is hovered is stronger.
// Inputs: color; shape, the plane's axes in eye space with the middle's pixel and the arrow's length, and how the eye sees
// directions (handle.h). Output: color.
#include "lib/frame.glsl"

const float middle_radius = 0.2, ring_radius = 0.7;  // of handle.h
const float head = 0.26, head_radius = 0.075;        // the arrow's, in its lengths
const vec3 ground = vec3(0.9), strong = vec3(1.0, 0.72, 0.2);

vec4 texel(int i) { return shape_at(vec2((float(i) + 0.5) / 4.0, 0.5)); }

// Paint on what is already there, both with associated alpha.
vec4 over(vec4 paint, vec4 ground) { return paint + (1.0 - paint.a) * ground; }

// A line so far away, both in pixels, with a dark margin that keeps it visible over bright pictures.
vec4 inked(float away, float width, vec3 color, float strength) {
  float line = clamp(0.5 * width + 0.5 - away, 0.0, 1.0), rim = clamp(0.5 * width + 1.5 - away, 0.0, 1.0);
  return strength * over(vec4(color, 1) * line, vec4(0, 0, 0, 0.55 * rim));
}

vec2 across(vec3 direction, vec2 slant) { return direction.xy + slant * direction.z; }

// The point of the plane through the middle with this normal that is seen at a place; eye space.
vec3 on_plane(vec2 at, vec3 normal, vec3 eye) {
  float facing = dot(normal, eye);
  return vec3(at, 0) - dot(normal.xy, at) / (abs(facing) < 0.02 ? (facing < 0.0 ? -0.02 : 0.02) : facing) * eye;
}

// How far a place is from a circle about the middle (negative: within), along the screen.
float to_circle(vec2 at, vec3 point, vec3 normal, vec3 eye, float radius) {
  float facing = dot(normal, eye);
  facing = abs(facing) < 0.02 ? (facing < 0.0 ? -0.02 : 0.02) : facing;
  float from_middle = max(length(point), 1e-6);
  vec2 slope = (point.xy - normal.xy / facing * dot(point, eye)) / from_middle;
  return (from_middle - radius) / max(length(slope), 1e-6);
}

vec4 ring(vec2 at, vec3 axis, vec3 eye, float pixels, bool hot) {
  vec3 point = on_plane(at, axis, eye);
  float away = abs(to_circle(at, point, axis, eye, ring_radius)) * pixels;
  bool front = dot(point, eye) >= 0.0;
  float width = max(0.02 * pixels, 1.0) * (hot ? 1.6 : 1.0);
  return inked(away, width, hot ? strong : ground, front ? 0.95 : 0.3);
}

vec4 disk(vec2 at, vec3 normal, vec3 eye, float pixels, bool hot) {
  float away = to_circle(at, on_plane(at, normal, eye), normal, eye, middle_radius) * pixels;
  vec3 color = hot ? strong : ground;
  vec4 fill = vec4(color, 1) * (hot ? 0.7 : 0.35) * clamp(0.5 - away, 0.0, 1.0);
  return over(inked(abs(away), max(0.02 * pixels, 1.0), color, 0.95), fill);
}

vec4 arrow(vec2 at, vec3 normal, vec2 slant, float pixels, bool hot) {
  vec2 tip = across(normal, slant), neck = (1.0 - head) * tip, path = tip - neck;
  float shown = max(length(path), 1e-6);
  vec2 along = path / shown, to_neck = at - neck;
  float way = dot(to_neck, along), aside = abs(dot(to_neck, vec2(-along.y, along.x)));
  // The head's base is a disk across the normal.
  float base = length(vec2(aside, way / max(abs(normal.z), 0.03))) - head_radius;
  float side = (aside - head_radius * (1.0 - way / shown)) * shown / length(vec2(shown, head_radius));
  float to_head = way > 0.0 ? max(side, way - shown) : base;
  float on_shaft = clamp(dot(at, tip) / max(dot(tip, tip), 1e-12), 0.0, 1.0 - head);
  vec3 color = hot ? strong : ground;
  vec4 shaft = inked(length(at - on_shaft * tip) * pixels, max(0.03 * pixels, 1.0) * (hot ? 1.6 : 1.0), color, 0.95);
  return over(inked(max(to_head, 0.0) * pixels, 1.0, color, 0.95), shaft);
}

vec4 render(Properties p, Pixel pixel) {
  vec4 scene = color_at(pixel.uv), x = texel(0), y = texel(1), normal = texel(2);
  vec2 slant = texel(3).xy, at = (vec2(pixel.coordinate) + 0.5 - vec2(x.w, y.w)) / max(normal.w, 1e-6);
  float pixels = normal.w;
  if (pixels <= 0.0 || dot(at, at) > 1.5 * (1.0 + dot(slant, slant))) return scene;
  vec3 eye = vec3(-slant, 1);
  vec4 rings = over(ring(at, x.xyz, eye, pixels, p.hovered == 3), ring(at, y.xyz, eye, pixels, p.hovered == 4));
  vec4 shaft = arrow(at, normal.xyz, slant, pixels, p.hovered == 2), middle = disk(at, normal.xyz, eye, pixels, p.hovered == 1);
  bool away = dot(normal.xyz, eye) < 0.0;  // the arrow points away from the eye: the disk covers it
  return over(away ? over(middle, over(shaft, rings)) : over(shaft, over(middle, rings)), scene);
}
