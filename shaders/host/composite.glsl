// Small steps between passes: transparent color over the lit scene, and the mean of the samples of a pixel.

uniform sampler2D lumen_source, lumen_over, lumen_depths;
uniform vec4 lumen_begin;  // of the window in the result, the border around the samples

layout(location = 0) out vec4 lumen_result;
layout(location = 1) out float lumen_depth;

// Associated color over the opaque scene.
void merge() {
  vec4 below = texelFetch(lumen_source, ivec2(gl_FragCoord.xy), 0);
  vec4 above = texelFetch(lumen_over, ivec2(gl_FragCoord.xy), 0);
  lumen_result = above + (1.0 - above.a) * below;
}

// As it is.
void shifted() { lumen_result = texelFetch(lumen_source, ivec2(gl_FragCoord.xy) - ivec2(lumen_begin.xy), 0); }

// What the occlusion leaves.
void unoccluded() { shifted(); lumen_result.rgb *= 1.0 - texelFetch(lumen_over, ivec2(gl_FragCoord.xy), 0).r; }
void illuminated() { shifted(); lumen_result.rgb *= texelFetch(lumen_over, ivec2(gl_FragCoord.xy), 0).rgb; }

ivec2 first_sample() { return 2 * (ivec2(gl_FragCoord.xy) - ivec2(lumen_begin.xy)) + ivec2(lumen_begin.z); }

// Of the 2 x 2 samples of a pixel; blending makes the mean with earlier ones.
void mean() {
  ivec2 at = first_sample();
  lumen_result = 0.25 * (texelFetch(lumen_source, at, 0) + texelFetch(lumen_source, at + ivec2(1, 0), 0) +
                         texelFetch(lumen_source, at + ivec2(0, 1), 0) + texelFetch(lumen_source, at + ivec2(1, 1), 0));
}

// The lower left one: normal, depth and depth buffer.
void pick() {
  ivec2 at = first_sample();
  lumen_result = texelFetch(lumen_source, at, 0);
  lumen_depth = texelFetch(lumen_over, at, 0).r;
  gl_FragDepth = texelFetch(lumen_depths, at, 0).r;
}
