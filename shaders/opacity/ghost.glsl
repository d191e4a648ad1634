// Background and ghost, mixed by the membership of a place; the ghost's silhouettes stay. Bruckner, Groeller, VolumeShop, IEEE
// Visualization 2005. Inputs: position, normal, eye. Output: 0..1.
#include "lib/frame.glsl"
#include "lib/surface.glsl"

float opacity(Properties p, Surface s) {
  vec3 center = (lumen.view * vec4(p.center, 1)).xyz;
  float radius = p.radius * lumen.extent.z, soft = max(p.softness * radius, 1e-6 * lumen.extent.z);
  float membership = 1.0 - smoothstep(radius - soft, radius + soft, distance(s.position, center));
  float edge = pow(1.0 - min(abs(dot(s.normal, s.to_eye)), 1.0), p.sharpness);
  return mix(p.background, mix(p.faintest, p.features, edge), membership);
}
