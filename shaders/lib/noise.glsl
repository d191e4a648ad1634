// Numbers that look random and are the same in every run.

// 0..1 from a pixel. Jarzynski, Olano, Hash Functions for GPU Rendering, JCGT 2020 (pcg2d).
vec2 hash(ivec2 pixel) {
  uvec2 v = uvec2(pixel) * 1664525u + 1013904223u;
  v.x += v.y * 1664525u;
  v.y += v.x * 1664525u;
  v ^= v >> 16u;
  v.x += v.y * 1664525u;
  v.y += v.x * 1664525u;
  v ^= v >> 16u;
  return vec2(v) * (1.0 / 4294967296.0);
}
