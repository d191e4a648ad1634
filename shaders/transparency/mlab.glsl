// Multi-layer alpha blending. Salvi, Vaidyanathan, Multi-Layer Alpha Blending, I3D 2014.
// Inputs: lit fragments. Output: associated color; exact for as many layers as there are nodes.
#include "lib/blending.glsl"
#include "lib/fragment_lists.glsl"

void store(Properties p, Fragment f) { list_store(f); }

vec4 associated(uint node) {
  vec4 color = list_color(node);
  return vec4(color.rgb * color.a, color.a);
}

// The nodes keep the nearest fragments. What falls out goes into sums, which do not care when.
vec4 by_sums(Properties p, uint head) {
  ListNearest nearest;
  list_clear(nearest);
  vec4 sum = vec4(0);
  float revealage = 1.0;
  for (uint at = head; at != 0u; at = list_next(at)) {
    float depth = list_depth(at);
    uint node = at;
    list_insert(nearest, p.nodes, depth, node);
    if (node == 0u) continue;
    vec4 color = associated(node);
    sum += color * normalized_weight(depth, p.decay);
    revealage *= 1.0 - color.a;
  }
  vec4 result = vec4(0);
  for (int i = 0; i < list_nearest_count; ++i)
    if (nearest.node[i] != 0u) result = over(result, associated(nearest.node[i]));
  return over(result, averaged(sum, revealage));
}

// The nodes hold colors. What falls out lies behind the last node, which takes it in and keeps its own depth.
vec4 by_merging(Properties p, uint head) {
  float depths[list_nearest_count];
  vec4 colors[list_nearest_count];
  for (int i = 0; i < list_nearest_count; ++i) {
    depths[i] = uintBitsToFloat(0x7F800000u);
    colors[i] = vec4(0);
  }
  for (uint at = head; at != 0u; at = list_next(at)) {
    float depth = list_depth(at);
    vec4 color = associated(at);
    for (int i = 0; i < list_nearest_count; ++i) {
      if (i >= p.nodes || depth >= depths[i]) continue;
      float other_depth = depths[i];
      vec4 other = colors[i];
      depths[i] = depth;
      colors[i] = color;
      depth = other_depth;
      color = other;
    }
    for (int i = 0; i < list_nearest_count; ++i)
      if (i == p.nodes - 1) colors[i] = over(colors[i], color);
  }
  vec4 result = vec4(0);
  for (int i = 0; i < list_nearest_count; ++i) result = over(result, colors[i]);
  return result;
}

vec4 resolve(Properties p, Pixel pixel) {
  uint head = list_head(pixel.coordinate);
  return p.merge == 0 ? by_sums(p, head) : by_merging(p, head);
}
