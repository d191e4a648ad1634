// A depth buffer at another size, from the pixels that center_of() of lib/occlusion.glsl chooses.

uniform sampler2D lumen_depths;
uniform vec4 lumen_size;  // of the result, of lumen_depths

void main() {
  vec2 place = floor(gl_FragCoord.xy / lumen_size.xy * lumen_size.zw + 0.25);
  gl_FragDepth = texelFetch(lumen_depths, ivec2(place), 0).r;
}
