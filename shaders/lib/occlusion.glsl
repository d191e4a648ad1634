// What all screen-space occlusions share: the pattern of their noise, and how refinements add up.
// The pattern is fixed on the pixels and holds each of 16 values once in every 4x4 pixels, so that lib/occlusion_blur.glsl removes it exactly.
// Inputs of a gathering pass: before = what the refinements so far gave, refinement = their number, one texel.
#include "lib/frame.glsl"

// The center of the layers' pixel that a pixel of any resolution stands for.
vec2 center_of(vec2 uv) { return (floor(uv * lumen.size.xy + 0.25) + 0.5) / lumen.size.xy; }

// Two numbers in 0..1 per pixel, apart from each other in the plane; other ones in each refinement.
// Roberts, The Unreasonable Effectiveness of Quasirandom Sequences, 2018.
vec2 pattern_at(ivec2 pixel, float refinement) {
  int index = ((pixel.x & 3) * 4 + (pixel.y & 3)) * 7 & 15;  // an odd factor: neighbors get distant turns
  int mirrored = (index & 1) * 8 + (index & 2) * 2 + (index & 4) / 2 + (index & 8) / 8;
  return fract((vec2(index, mirrored) + 0.5) / 16.0 + refinement * vec2(0.75487767, 0.56984029));
}

// What a gathering pass stores: the sum over the refinements, and the depth that the blur compares.
vec4 gathered(float occlusion, float depth, float refinement, vec2 before) {
  return vec4(clamp(occlusion, 0.0, 1.0) + (refinement > 0.0 ? before.r : 0.0), depth, 0, 1);
}

// How much an occluder at a distance counts.
float weight_of(float range, float radius, bool falloff) {
  float nearness = 1.0 - range / radius;
  return falloff ? clamp(2.0 * nearness, 0.0, 1.0) : step(0.0, nearness);
}
