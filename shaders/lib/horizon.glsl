// Slices through the direction to the eye, as horizon-based occlusions search them: in the plane of a slice, angles are measured from the
// eye's direction toward the slice's side. Jimenez, Wu, Pesce, Jarabo, Practical Realtime Strategies for Accurate Indirect Occlusion, 2016.
#include "lib/occlusion.glsl"

// The pixel whose horizons are searched.
struct Viewpoint {
  vec3 position, normal, eye;  // view space; eye: unit, toward it
  vec2 place;                  // pixels of the layers
};

struct Slice {
  vec2 direction;     // in the picture, unit
  vec3 side, across;  // unit, perpendicular to the eye's direction: in the slice, and to the slice
  vec2 normal;        // along side and eye, of the normal's projection: not unit
  float slant;        // the normal's part across
  float length, tilt; // of the projected normal, and its angle
};

Viewpoint viewpoint_at(vec2 uv, float depth) {
  vec3 position = position_from(uv, depth);
  return Viewpoint(position, normal_at(uv), to_eye(position), uv * lumen.size.xy);
}

Slice slice_at(Viewpoint at, float angle) {
  Slice slice;
  slice.direction = vec2(cos(angle), sin(angle));
  vec3 flat_side = vec3(slice.direction, 0);
  slice.side = normalize(flat_side - at.eye * dot(flat_side, at.eye));
  slice.across = cross(slice.side, at.eye);
  slice.normal = vec2(dot(at.normal, slice.side), max(dot(at.normal, at.eye), 1e-3));
  slice.slant = dot(at.normal, slice.across);
  slice.length = length(slice.normal);
  slice.tilt = atan(slice.normal.x, slice.normal.y);
  return slice;
}

// How many pixels there are to search toward `direction`: to the radius or the picture's edge.
float search_length(Viewpoint at, vec2 direction, float radius) {
  vec2 room = mix(at.place, lumen.size.xy - at.place, step(0.0, direction)) / max(abs(direction), 1e-6);
  return clamp(pixels_of(radius, -at.position.z), 1.0, max(min(room.x, room.y) - 0.5, 1.0));
}

// Where sample `fraction` (0..1) of a search is: denser near the pixel, and never the pixel itself.
vec2 search_uv(Viewpoint at, vec2 direction, float pixels, float fraction) {
  vec2 place = at.place + direction * (1.0 + (pixels - 1.0) * fraction * fraction);
  return (floor(place) + 0.5) / lumen.size.xy;
}

// Whether a sample shows an occluder: it lies in the picture, and something is there.
bool found_at(vec2 uv, float stored) { return !isinf(stored) && all(lessThan(abs(uv - 0.5), vec2(0.5))); }

// An offset in the slice's coordinates (along side and eye). A sample is a pixel's center, a little beside the slice: it comes into
// the slice at its height over the tangent plane, so that a plane is its own horizon exactly.
vec2 in_slice(Slice slice, Viewpoint at, vec3 offset) {
  vec2 inside = vec2(dot(offset, slice.side), dot(offset, at.eye));
  return inside + slice.normal * (slice.slant * dot(offset, slice.across) / (slice.length * slice.length));
}

// The integral from the eye's direction to `angle` of cosine to the normal times sine to the eye: cosine-weighted solid angle.
float cosine_arc(Slice slice, float angle) {
  return 0.25 * (cos(slice.tilt) - cos(2.0 * angle - slice.tilt) + 2.0 * angle * sin(slice.tilt));
}
