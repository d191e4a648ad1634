// Order-independent transparency by weighted sums. McGuire, Bavoil, Weighted Blended Order-Independent Transparency, JCGT 2013.
// Inputs: lit fragments. Outputs: sum of (C a, a) w and prod(1 - a); resolved: associated color.
#include "lib/blending.glsl"
#include "lib/surface.glsl"

float weight_of(Properties p, Fragment f) {
  float z = f.depth;
  if (p.weight == 0) return normalized_weight(z, p.decay);
  if (p.weight == 2) return f.alpha * clamp(10.0 / (1e-5 + pow(z / 5.0, 2.0) + pow(z / 200.0, 6.0)), 1e-2, 3e3);
  if (p.weight == 3) return f.alpha * clamp(10.0 / (1e-5 + pow(z / 10.0, 3.0) + pow(z / 200.0, 6.0)), 1e-2, 3e3);
  if (p.weight == 4) return f.alpha * clamp(0.03 / (1e-5 + pow(z / 200.0, 4.0)), 1e-2, 3e3);
  if (p.weight == 5) return f.alpha * max(1e-2, 3e3 * pow(1.0 - gl_FragCoord.z, 3.0));
  return 1.0;
}

void store(Properties p, Fragment f) {
  sum = vec4(f.color * f.alpha, f.alpha) * weight_of(p, f);
  revealage = vec4(f.alpha);
}

vec4 resolve(Properties p, Pixel pixel) { return averaged(sum_at(pixel.uv), revealage_at(pixel.uv)); }
