// Depth unsharp masking: color + strength * (G * D - D). Luft, Colditz, Deussen, SIGGRAPH 2006.
// D is scene depth, 1 on the background. Inputs: color, depth. Output: color; alpha as it was.
#include "lib/frame.glsl"

float importance_depth(vec2 uv) {
  float depth = depth_at(uv);
  return isinf(depth) ? 1.0 : scene_depth(depth);
}

vec2 texels(Pixel pixel) { return round((vec2(pixel.coordinate) + 0.5) / pixel.uv); }  // of the target

// The mean of the texel's pixels.
vec4 shrink(Properties p, Pixel pixel) {
  vec2 size = texels(pixel);
  ivec2 count = ivec2(ceil(lumen.size.xy / size));
  float sum = 0.0;
  for (int y = 0; y < count.y; ++y)
    for (int x = 0; x < count.x; ++x)
      sum += importance_depth((vec2(pixel.coordinate) + (vec2(x, y) + 0.5) / vec2(count)) / size);
  return vec4(sum / float(count.x * count.y));
}

// Standard deviation in texels along an axis; averaging over a texel has added (n^2 - 1) / 12 pixels^2 to the variance.
float deviation(Properties p, Pixel pixel, int axis) {
  float pixels = p.radius * length(lumen.size.xy - 2.0 * lumen.size.z);
  float n = (lumen.size.xy / texels(pixel))[axis];
  return sqrt(max(pixels * pixels - (n * n - 1.0) / 12.0, 1e-4)) / n;
}

float weight(int i, float width) { return exp(-0.5 * float(i * i) / (width * width)); }

vec4 blur_rows(Properties p, Pixel pixel) {
  float width = deviation(p, pixel, 0), sum = 0.0, weights = 0.0;
  int reach = int(ceil(3.0 * width));
  for (int i = -reach; i <= reach; ++i) {
    sum += weight(i, width) * shrunk_at(pixel.uv + vec2(i, 0) / texels(pixel));
    weights += weight(i, width);
  }
  return vec4(sum / weights);
}

vec4 blur_columns(Properties p, Pixel pixel) {
  float width = deviation(p, pixel, 1), sum = 0.0, weights = 0.0;
  int reach = int(ceil(3.0 * width));
  for (int i = -reach; i <= reach; ++i) {
    sum += weight(i, width) * rows_at(pixel.uv + vec2(0, i) / texels(pixel));
    weights += weight(i, width);
  }
  return vec4(sum / weights);
}

vec4 render(Properties p, Pixel pixel) {
  vec4 scene = color_at(pixel.uv);
  float change = p.strength * (smooth_depth_at(pixel.uv) - importance_depth(pixel.uv));
  if (p.halos == 1) change = min(change, 0.0);
  if (p.halos == 2) change = max(change, 0.0);
  return vec4(max(scene.rgb + change * scene.a, 0.0), scene.a);
}
