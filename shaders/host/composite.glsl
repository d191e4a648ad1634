// Small steps between passes: transparent color over the lit scene, and the mean of the samples of a pixel.

uniform sampler2D lumen_source, lumen_over;

layout(location = 0) out vec4 lumen_result;

// Associated color over the opaque scene.
void merge() {
  vec4 below = texelFetch(lumen_source, ivec2(gl_FragCoord.xy), 0);
  vec4 above = texelFetch(lumen_over, ivec2(gl_FragCoord.xy), 0);
  lumen_result = above + (1.0 - above.a) * below;
}

// As it is; blending makes the mean.
void copy() { lumen_result = texelFetch(lumen_source, ivec2(gl_FragCoord.xy), 0); }
