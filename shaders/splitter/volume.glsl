// A sphere, box, wedge or tube cut out of surfaces. Knoedel, Hachet, Guitton, Interactive Generation and Modification of Cutaway
// Illustrations for Polygonal Models, Smart Graphics 2009. All are convex: what faces bound. Inputs: the place before any move.
#include "lib/splitter.glsl"

const int sphere = 0, box = 1, wedge = 2, tube = 3;

// A world direction along the volume's own axes.
vec3 own_direction(Properties p, vec3 world) {
  vec4 q = p.rotation;
  return world + 2.0 * cross(-q.xyz, cross(-q.xyz, world) + q.w * world);
}

vec3 world_direction(Properties p, vec3 own) {
  vec4 q = p.rotation;
  return own + 2.0 * cross(q.xyz, cross(q.xyz, own) + q.w * own);
}

// Half the volume's extent along its own axes, where flat faces end it.
vec3 half_extent(Properties p) { return p.shape == box ? 0.5 * p.size : vec3(1e30, 1e30, p.shape == sphere ? 1e30 : 0.5 * p.length); }

// The wedge's two sides: the outward normal in its own xy plane, y positive.
vec2 side_normal(Properties p) { return vec2(-sin(radians(0.5 * p.angle)), cos(radians(0.5 * p.angle))); }

bool within(Properties p, vec3 own) {
  if (any(greaterThan(abs(own), half_extent(p)))) return false;
  if (p.shape == box) return true;
  vec3 arm = p.shape == sphere ? own : vec3(own.xy, 0);
  if (dot(arm, arm) > p.radius * p.radius) return false;
  return p.shape != wedge || dot(vec2(own.x, abs(own.y)), side_normal(p)) <= 0.0;
}

bool removed(Properties p, Surface s) { return within(p, own_direction(p, s.place - p.center)) != (p.keep == 1); }

// A ray through the volume, so far.
struct Way {
  float enter, leave;
  vec3 wall;  // inward normal where it comes in
};

// Cuts it where dot(outward, x) = offset.
void face(inout Way way, vec3 origin, vec3 direction, vec3 outward, float offset) {
  float speed = dot(outward, direction), room = offset - dot(outward, origin);
  if (abs(speed) < 1e-12) {
    if (room < 0.0) way.leave = -1e30;
  } else if (speed > 0.0) {
    way.leave = min(way.leave, room / speed);
  } else if (room / speed > way.enter) {
    way.enter = room / speed;
    way.wall = -outward;
  }
}

// Cuts it where it leaves the sphere, or the cylinder about z.
void round_face(inout Way way, vec3 origin, vec3 direction, float radius, bool cylinder) {
  vec3 along = cylinder ? vec3(1, 1, 0) : vec3(1), o = origin * along, d = direction * along;
  float a = dot(d, d), b = dot(o, d), c = dot(o, o) - radius * radius;
  if (a < 1e-12) {
    if (c > 0.0) way.leave = -1e30;
    return;
  }
  float inner = b * b - a * c;
  if (inner < 0.0) {
    way.leave = -1e30;
    return;
  }
  float root = sqrt(inner), enter = (-b - root) / a;
  way.leave = min(way.leave, (-b + root) / a);
  if (enter > way.enter) {
    way.enter = enter;
    way.wall = -(o + enter * d) / max(radius, 1e-30);
  }
}

// From the inside that is seen toward the eye, the first wall of the volume.
vec3 cut_normal(Properties p, Surface s) {
  vec3 eye_ray = mat3(lumen_eye_to_world) * s.to_eye;
  vec3 origin = own_direction(p, s.place - p.center), direction = own_direction(p, eye_ray), reach = half_extent(p);
  Way way = Way(-1e30, 1e30, vec3(0));
  for (int axis = 0; axis < 3; ++axis) {
    if (reach[axis] > 1e29) continue;
    vec3 outward = vec3(0);
    outward[axis] = 1.0;
    face(way, origin, direction, outward, reach[axis]);
    face(way, origin, direction, -outward, reach[axis]);
  }
  if (p.shape != box) round_face(way, origin, direction, p.radius, p.shape != sphere);
  if (p.shape == wedge) {
    vec2 side = side_normal(p);
    face(way, origin, direction, vec3(side, 0), 0.0);
    face(way, origin, direction, vec3(side.x, -side.y, 0), 0.0);
  }
  // Seen through a hole that the surface has itself: as it is lit without a cut.
  if (way.enter >= way.leave || way.leave < 0.0) return mat3(lumen_eye_to_world) * s.normal;
  return world_direction(p, way.wall);
}
