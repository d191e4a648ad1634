// Lines of a given width over the edges between pixels where the depth or, for creases, the normal jumps.
// Saito, Takahashi, Comprehensible Rendering of 3-D Shapes, SIGGRAPH 1990; the distance to the edges by rows, then columns.
// Inputs: color, depth, normal. Output: color.
#include "lib/frame.glsl"

const float nowhere = 1e4;  // squared pixels, farther than any line reaches

// Whether two neighbors belong to different surfaces. Each must be off the other's tangent plane or seem to be: a tilted
// plane has no lines however steep, a step has one however the nearer surface turns away at its rim.
float edge_between(Properties p, vec2 a, vec2 b) {
  float depth_a = depth_at(a), depth_b = depth_at(b);
  bool covered_a = !isinf(depth_a), covered_b = !isinf(depth_b);
  if (covered_a != covered_b) return 1.0;
  if (!covered_a) return 0.0;
  vec3 normal_a = normal_at(a), normal_b = normal_at(b);
  vec3 path = position_from(b, depth_b) - position_from(a, depth_a);
  float off = max(abs(dot(normal_a, path)), abs(dot(normal_b, path)));
  if (off > p.step * lumen.extent.z) return 1.0;
  return p.creases && dot(normal_a, normal_b) < cos(radians(p.angle)) ? 1.0 : 0.0;
}

// Edges to the right of the pixel, and above it.
vec4 edges_of(Properties p, Pixel pixel) {
  vec2 right = vec2(pixel.uv.x + 1.0 / lumen.size.x, pixel.uv.y), above = vec2(pixel.uv.x, pixel.uv.y + 1.0 / lumen.size.y);
  return vec4(right.x < 1.0 ? edge_between(p, pixel.uv, right) : 0.0, above.y < 1.0 ? edge_between(p, pixel.uv, above) : 0.0, 0, 0);
}

int reach(Properties p) { return int(ceil(0.5 * p.width + 0.5)); }

// Squared distance to the middle of the nearest edge of each direction in the pixel's row.
vec4 nearest_in_row(Properties p, Pixel pixel) {
  vec2 nearest = vec2(nowhere);
  for (int x = -reach(p); x <= reach(p); ++x) {
    vec2 there = edges_at(pixel.uv + vec2(x, 0) / lumen.size.xy);
    vec2 off = vec2(float(x) + 0.5, x);
    nearest = min(nearest, mix(vec2(nowhere), off * off, there));
  }
  return vec4(nearest, 0, 0);
}

// How much of the pixel a line covers.
vec4 line_over(Properties p, Pixel pixel) {
  float nearest = nowhere;
  for (int y = -reach(p); y <= reach(p); ++y) {
    vec2 row = across_at(pixel.uv + vec2(0, y) / lumen.size.xy);
    vec2 off = vec2(y, float(y) + 0.5);
    row += off * off;
    nearest = min(nearest, min(row.x, row.y));
  }
  return vec4(clamp(0.5 * p.width + 0.5 - sqrt(nearest), 0.0, 1.0));
}

// The edges are stairs of pixels: a tent over 3x3 smooths them and keeps the line's width.
vec4 render(Properties p, Pixel pixel) {
  float line = 0.0;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x)
      line += (x == 0 ? 0.5 : 0.25) * (y == 0 ? 0.5 : 0.25) * stairs_at(pixel.uv + vec2(x, y) / lumen.size.xy);
  return mix(color_at(pixel.uv), vec4(p.color, 1), p.opacity * line);
}
