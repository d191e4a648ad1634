// Exact transparency by sorted lists. Yang, Hensley, Gruen, Thibieroz, Real-Time Concurrent Linked List Construction on the
// GPU, EGSR 2010. Inputs: lit fragments. Output: associated color of all of them, nearest first.
#include "lib/fragment_lists.glsl"

void store(Properties p, Fragment f) { list_store(f); }

// Eight fragments at a time, the nearest that are left: one walk for most pixels, and no limit to a list's length.
vec4 resolve(Properties p, Pixel pixel) {
  uint head = list_head(pixel.coordinate);
  vec3 color = vec3(0);
  float transmittance = 1.0, last_depth = 0.0;
  uint last = 0u;
  bool more = head != 0u;
  while (more) {
    more = false;
    ListNearest nearest;
    list_clear(nearest);
    for (uint at = head; at != 0u; at = list_next(at)) {
      float depth = list_depth(at);
      uint node = at;
      if (last != 0u && (depth < last_depth || (depth == last_depth && !list_precedes(last, node)))) continue;
      list_insert(nearest, list_nearest_count, depth, node);
      if (node != 0u) more = true;
    }
    for (int i = 0; i < list_nearest_count; ++i) {
      if (nearest.node[i] == 0u) break;
      vec4 fragment = list_color(nearest.node[i]);
      color += transmittance * fragment.a * fragment.rgb;
      transmittance *= 1.0 - fragment.a;
    }
    last = nearest.node[list_nearest_count - 1];
    last_depth = nearest.depth[list_nearest_count - 1];
  }
  return vec4(color, 1.0 - transmittance);
}
