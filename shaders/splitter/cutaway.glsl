// Holes before what is of interest: Burns, Finkelstein, Adaptive Cutaways for Comprehensible Rendering of Polygonal Scenes, SIGGRAPH
// Asia 2008. A pixel q of interest removes what lies in its cone, whose wall leaves the line of sight by the slope:
//   parallel:     z < z_q - cot(slope) |p - q|          p, q: places on the view plane, world
//   perspective:  z < z_q / (1 + cot(slope) |p - q|)    p, q: places at distance 1 from the eye
// and the cutaway is the union of the cones. Which cone reaches farthest is found for squares of `reduction` pixels by jump flooding,
// Rong, Tan, I3D 2006; each fragment then compares those of the four squares around it.
// Inputs: cutaway_hull, the farthest depth of what is of interest, else -inf; cutaway_seeds, a pixel q: place, depth, whether there is one.
#include "lib/splitter.glsl"

struct View {
  vec4 unproject;  // place = uv * xy + zw
  vec2 pixels;     // of the picture
  bool parallel;
};

vec2 place_of(View v, vec2 pixel) { return pixel / v.pixels * v.unproject.xy + v.unproject.zw; }

float cotangent(Properties p) { return 1.0 / max(tan(radians(p.slope)), 1e-4); }

// How far from q its cone begins: half a pixel's width is what the picture cannot tell from q.
float cone_radius(Properties p, View v, vec4 q) {
  return p.margin * lumen.extent.z / (v.parallel ? 1.0 : q.z) + 0.75 * v.unproject.x / v.pixels.x;
}

// Depth of the cone's wall.
float wall(Properties p, View v, vec4 q, vec2 place) {
  if (q.w == 0.0) return -1e30;
  float away = cotangent(p) * max(distance(place, q.xy) - cone_radius(p, v, q), 0.0);
  return v.parallel ? q.z - away : q.z / (1.0 + away);
}

// Of the pixels of the square, the one whose cone reaches farthest at the square's center.
vec4 seed(Properties p, Pixel pixel) {
  View v = View(lumen.unproject, vec2(textureSize(cutaway_hull, 0)), orthographic());
  vec2 center = place_of(v, (vec2(pixel.coordinate) + 0.5) * float(p.reduction));
  ivec2 first = pixel.coordinate * p.reduction, end = min(first + p.reduction, ivec2(v.pixels));
  vec4 best = vec4(0);
  float farthest = -1e30;
  for (int y = first.y; y < end.y; ++y)
    for (int x = first.x; x < end.x; ++x) {
      float depth = texelFetch(cutaway_hull, ivec2(x, y), 0).r;
      if (isinf(depth)) continue;
      vec4 q = vec4(place_of(v, vec2(x, y) + 0.5), depth, 1);
      float reach = wall(p, v, q, center);
      if (reach > farthest) { farthest = reach; best = q; }
    }
  return best;
}

// The best of nine squares so far apart.
vec4 spread(Properties p, Pixel pixel) {
  View v = View(lumen.unproject, vec2(textureSize(cutaway_hull, 0)), orthographic());
  vec2 center = place_of(v, (vec2(pixel.coordinate) + 0.5) * float(p.reduction));
  int apart = int(stride_at(vec2(0.5)));
  ivec2 last = textureSize(cutaway_seeds, 0) - 1;
  vec4 best = vec4(0);
  float farthest = -1e30;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) {
      ivec2 at = pixel.coordinate + apart * ivec2(x, y);
      if (any(lessThan(at, ivec2(0))) || any(greaterThan(at, last))) continue;
      vec4 q = texelFetch(cutaway_seeds, at, 0);
      float reach = wall(p, v, q, center);
      if (reach > farthest) { farthest = reach; best = q; }
    }
  return best;
}

View main_view() { return View(lumen_main_unproject, vec2(textureSize(cutaway_hull, 0)), lumen_main_orthographic != 0); }

// The square up and right of the corner next to a place of the picture, and how far it is toward it.
ivec2 squares_at(Properties p, View v, vec2 uv, out vec2 part) {
  vec2 at = uv * v.pixels / float(p.reduction) - 0.5;
  part = clamp(at - floor(at), 0.0, 1.0);
  return ivec2(floor(at));
}

vec4 seed_at(ivec2 square) { return texelFetch(cutaway_seeds, clamp(square, ivec2(0), textureSize(cutaway_seeds, 0) - 1), 0); }

bool removed(Properties p, Surface s) {
  View v = main_view();
  vec3 seen = main_place(to_world(s.position));
  vec2 part, place = seen.xy * v.unproject.xy + v.unproject.zw;
  ivec2 square = squares_at(p, v, seen.xy, part);
  float deepest = all(equal(seen.xy, clamp(seen.xy, 0.0, 1.0))) ? cutaway_hull_at(seen.xy) : -1e30;
  for (int i = 0; i < 4; ++i) deepest = max(deepest, wall(p, v, seed_at(square + ivec2(i & 1, i >> 1)), place));
  return (seen.z < deepest) != (p.keep == 1);
}

// Of the cone's wall, view space of the view's camera: away from what remains.
vec3 wall_normal(Properties p, View v, vec4 q, vec2 place) {
  vec2 outward = place - q.xy;
  float away = length(outward);
  if (q.w == 0.0 || away == 0.0) return vec3(0, 0, 1);
  outward *= cotangent(p) / away;
  return normalize(vec3(-outward, v.parallel ? 1.0 : 1.0 - dot(outward, q.xy)));
}

// Where the eye's ray meets the cutaway; between the squares' cones it turns smoothly.
vec3 cut_normal(Properties p, Surface s) {
  View v = main_view();
  vec3 seen = main_place(to_world(s.position));
  vec2 part, place = seen.xy * v.unproject.xy + v.unproject.zw;
  ivec2 square = squares_at(p, v, seen.xy, part);
  vec3 normal = vec3(0);
  for (int i = 0; i < 4; ++i) {
    ivec2 corner = ivec2(i & 1, i >> 1);
    vec2 weight = mix(1.0 - part, part, vec2(corner));
    normal += weight.x * weight.y * wall_normal(p, v, seed_at(square + corner), place);
  }
  return transpose(mat3(lumen_main_view)) * normalize(normal);
}
