// All transparent fragments of each pixel as a list, in no order. Yang, Hensley, Gruen, Thibieroz, Real-Time Concurrent
// Linked List Construction on the GPU, EGSR 2010. plugins/transparency/fragment_lists.h provides the storage.
#include "lib/frame.glsl"
#include "lib/surface.glsl"

// Node 0 is none, so that cleared storage holds empty lists.
layout(std430, binding = 10) buffer LumenListHeads {
  uint lumen_list_count;    // of all fragments, those that found no room, too
  uint lumen_list_heads[];  // of each pixel
};
layout(std430, binding = 11) buffer LumenListLinks { uint lumen_list_links[]; };    // per node: depth, order among equal depths, next
layout(std430, binding = 12) buffer LumenListColors { uvec2 lumen_list_colors[]; };

// 14 bits per channel under a shared exponent, and 17 of alpha: 3e-5 of the brightest channel, in two words.
uvec2 list_packed(vec3 color, float alpha) {
  color = clamp(color, 0.0, 32768.0);
  float brightest = max(max(color.r, color.g), color.b);
  uint exponent = max((floatBitsToUint(brightest) + 0x7FFFFFu) >> 23, 111u);
  uvec3 c = uvec3(color * (16383.0 * uintBitsToFloat((254u - exponent) << 23)) + 0.5);
  uint a = uint(alpha * 131071.0 + 0.5);
  return uvec2(c.r | c.g << 14 | a << 28, c.b | (exponent - 111u) << 14 | (a >> 4) << 19);
}

uint list_head(ivec2 pixel) { return lumen_list_heads[pixel.y * int(lumen.size.x) + pixel.x]; }
float list_depth(uint node) { return uintBitsToFloat(lumen_list_links[3u * node]); }
uint list_next(uint node) { return lumen_list_links[3u * node + 2u]; }

// Color, not multiplied by alpha, and alpha.
vec4 list_color(uint node) {
  uvec2 c = lumen_list_colors[node];
  float scale = uintBitsToFloat((((c.y >> 14) & 31u) + 111u) << 23) / 16383.0;
  return vec4(vec3(c.x & 16383u, (c.x >> 14) & 16383u, c.y & 16383u) * scale, float(c.x >> 28 | (c.y >> 19) << 4) / 131071.0);
}

// Whether one of two fragments of the same depth comes first: by surface, then by primitive as drawn. The renderer's own
// numbers are of no use here, since a drawing that leaves clusters out does not keep them.
bool list_precedes(uint node, uint other) {
  uint a = lumen_list_links[3u * node + 1u], b = lumen_list_links[3u * other + 1u];
  return a < b || (a == b && node < other);
}

void list_store(Fragment f) {
  uint node = atomicAdd(lumen_list_count, 1u) + 1u;
  if (node >= uint(lumen_list_colors.length())) return;
  int at = int(gl_FragCoord.y) * int(lumen.size.x) + int(gl_FragCoord.x);
  lumen_list_colors[node] = list_packed(f.color, f.alpha);
  lumen_list_links[3u * node] = floatBitsToUint(f.depth);
  lumen_list_links[3u * node + 1u] = uint(f.instance) << 25 ^ uint(f.part) << 22 ^ uint(gl_PrimitiveID);
  lumen_list_links[3u * node + 2u] = atomicExchange(lumen_list_heads[at], node);
}

// The nearest fragments of a list that were looked at so far, in order. Empty places have infinite depth.
const int list_nearest_count = 8;
struct ListNearest {
  float depth[list_nearest_count];
  uint node[list_nearest_count];
};

void list_clear(out ListNearest nearest) {
  for (int i = 0; i < list_nearest_count; ++i) {
    nearest.depth[i] = uintBitsToFloat(0x7F800000u);
    nearest.node[i] = 0u;
  }
}

// Puts a fragment in its place among the first `count`; what falls out at the end is in `depth` and `node` then.
void list_insert(inout ListNearest nearest, int count, inout float depth, inout uint node) {
  for (int i = 0; i < list_nearest_count; ++i) {
    bool first = depth < nearest.depth[i];
    if (depth == nearest.depth[i] && node != 0u && nearest.node[i] != 0u) first = list_precedes(node, nearest.node[i]);
    if (i >= count || !first) continue;
    float other_depth = nearest.depth[i];
    uint other = nearest.node[i];
    nearest.depth[i] = depth;
    nearest.node[i] = node;
    depth = other_depth;
    node = other;
  }
}
