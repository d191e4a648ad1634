// The values of all instances' properties, a row of vec4 each; the host generates the functions that read them.

layout(std430, binding = 0) readonly buffer LumenValues { vec4 lumen_values[]; };

// A transfer function: a row of the texture that holds them all.
struct TransferFunction {
  float row;
  vec2 range;
};

uniform sampler2D lumen_transfer_functions;

// Color and opacity at x; linear between the texels, clamped to the ends.
vec4 map(TransferFunction f, float x) {
  int texels = textureSize(lumen_transfer_functions, 0).x;
  float at = clamp((x - f.range.x) / (f.range.y - f.range.x), 0.0, 1.0) * float(texels - 1);
  int left = int(at);
  vec4 a = texelFetch(lumen_transfer_functions, ivec2(left, int(f.row)), 0);
  vec4 b = texelFetch(lumen_transfer_functions, ivec2(min(left + 1, texels - 1), int(f.row)), 0);
  return mix(a, b, at - float(left));
}

// A picture property: its place in the texture that holds all pictures; zero while there is none.
struct Image {
  vec4 place;  // corner and extent
};

uniform sampler2D lumen_images;

bool given(Image i) { return i.place.z > 0.0; }

// The picture's size in texels.
vec2 size_of(Image i) { return abs(i.place.zw) * vec2(textureSize(lumen_images, 0)); }

// Color at uv, 0..1 from the bottom left; bilinear, clamped to the edge; transparent black while there is no picture.
vec4 image(Image i, vec2 uv) {
  if (!given(i)) return vec4(0);
  vec2 margin = 0.5 / size_of(i);
  return textureLod(lumen_images, i.place.xy + clamp(uv, margin, 1.0 - margin) * i.place.zw, 0.0);
}
