// A cube that turns as the scene does, seen in parallel, its faces named by the world's axes; spheres where lights shine from.
// Khan et al., ViewCube, I3D 2008; lights as in Ostendorf 2021, section 4. Inputs: color. Output: color.
#include "lib/frame.glsl"

const float half_edge = 0.46, face_part = 0.62;         // of cube.h
const float marker_distance = 0.86, marker_radius = 0.1;  // in halves of the square

// Distance to a stroke.
float stroke(vec2 at, vec2 a, vec2 b) {
  vec2 path = b - a;
  return length(at - a - path * clamp(dot(at - a, path) / dot(path, path), 0.0, 1.0));
}

// Distance to the letter x, y or z, 1 high and about the origin, with a minus before it.
float letter(vec2 at, int axis, bool minus) {
  float off = 1e3;
  if (minus) {
    at.x -= 0.2;
    off = stroke(at, vec2(-0.75, 0), vec2(-0.45, 0));
  }
  if (axis == 0) return min(off, min(stroke(at, vec2(-0.32, -0.5), vec2(0.32, 0.5)), stroke(at, vec2(-0.32, 0.5), vec2(0.32, -0.5))));
  if (axis == 1) return min(off, min(min(stroke(at, vec2(-0.32, 0.5), vec2(0)), stroke(at, vec2(0.32, 0.5), vec2(0))), stroke(at, vec2(0), vec2(0, -0.5))));
  return min(off, min(min(stroke(at, vec2(-0.32, 0.5), vec2(0.32, 0.5)), stroke(at, vec2(0.32, 0.5), vec2(-0.32, -0.5))), stroke(at, vec2(-0.32, -0.5), vec2(0.32, -0.5))));
}

int part_of(float at) { return at > face_part ? 2 : (at < -face_part ? 0 : 1); }

// The color of a point of the cube's surface, -1..1; `axis` and `side` say which face.
vec3 face_color(Properties p, vec3 hit, int axis, float side, float facing) {
  vec3 color = vec3(0.62);
  color[axis] = 0.86;
  if (side < 0.0) color = mix(color, vec3(0.42), 0.45);
  // Upright as one sees the face after a click on it.
  vec3 outward = vec3(0), up = vec3(0, 0, 1);
  outward[axis] = side;
  if (axis == 2) up = vec3(0, side, 0);
  vec2 at = vec2(dot(hit, cross(up, outward)), dot(hit, up));
  ivec3 part = ivec3(part_of(hit.x), part_of(hit.y), part_of(hit.z));
  if (part.x * 9 + part.y * 3 + part.z == p.hovered) color = mix(color, vec3(1.0, 0.72, 0.2), 0.75);
  if (letter(at / 0.75, axis, side < 0.0) < 0.09) color = vec3(0.05);
  vec2 edge = abs(at);
  if (max(edge.x, edge.y) > 0.96) color *= 0.35;
  return color * mix(0.55, 1.0, facing);
}

// Premultiplied color over the square's point, -1..1 with y up.
vec4 sample_at(Properties p, vec2 point) {
  mat3 to_world = transpose(mat3(lumen.view));
  vec3 origin = to_world * vec3(point / half_edge, 0), direction = to_world * vec3(0, 0, -1);
  vec3 safe = mix(direction, vec3(1e-7), lessThan(abs(direction), vec3(1e-7)));
  vec3 enters = -origin / safe - 1.0 / abs(safe), leaves = -origin / safe + 1.0 / abs(safe);
  float enter = max(max(enters.x, enters.y), enters.z), leave = min(min(leaves.x, leaves.y), leaves.z);
  vec4 color = vec4(0);
  float nearest = -1e3;  // toward the eye, in halves of the square
  if (enter < leave) {
    int axis = enters.x >= max(enters.y, enters.z) ? 0 : (enters.y >= enters.z ? 1 : 2);
    color = vec4(face_color(p, clamp(origin + enter * direction, -1.0, 1.0), axis, -sign(direction[axis]), abs(direction[axis])), 1);
    nearest = -enter * half_edge;
  }
  for (int i = 0; i < 16; ++i) {
    vec4 marker = markers_at(vec2((float(i) + 0.5) / 16.0, 0.25));
    if (marker.w < 0.5) break;
    vec2 off = (point - marker_distance * marker.xy) / marker_radius;
    float height = 1.0 - dot(off, off);
    if (height < 0.0) continue;
    float front = marker_distance * marker.z + marker_radius * sqrt(height);
    if (front <= nearest) continue;
    nearest = front;
    vec3 shown = markers_at(vec2((float(i) + 0.5) / 16.0, 0.75)).rgb;
    shown /= max(max(max(shown.r, shown.g), shown.b), 1.0);  // strong lights keep their hue
    color = vec4(height < 0.35 ? shown * 0.25 : shown, 1);  // a rim, for bright grounds
  }
  return color * p.opacity;
}

vec4 render(Properties p, Pixel pixel) {
  vec4 scene = color_at(pixel.uv);
  vec2 whole = lumen.size.xy - 2.0 * lumen.size.z, at = pixel.uv * lumen.size.xy - lumen.size.z;
  float side = p.size * min(whole.x, whole.y);
  vec2 center = vec2((p.corner & 1) == 1 ? whole.x - 0.5 * side : 0.5 * side, p.corner < 2 ? whole.y - 0.5 * side : 0.5 * side);
  vec2 point = (at - center) / (0.5 * side);
  if (any(greaterThan(abs(point), vec2(1)))) return scene;
  vec4 over = vec4(0);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) over += sample_at(p, point + (vec2(x, y) - 1.5) / (2.0 * side)) / 16.0;
  return over + (1.0 - over.a) * scene;
}
