// Rough diffuse reflection. Oren, Nayar, Generalization of Lambert's Reflectance Model, SIGGRAPH 1994 (the qualitative model);
// Portsmouth, Kutz, Hill, EON: A Practical Energy-Preserving Rough Diffuse BRDF, 2024. Inputs: normal, eye, material, light.
// Output: radiance.
#include "lib/surface.glsl"

const float pi = 3.14159265359;

// Reflectance, times pi, for a white surface: symmetric in light and eye.
float qualitative(float sigma, float toward_light, float toward_eye, float across) {
  float square = sigma * sigma;
  float a = 1.0 - 0.5 * square / (square + 0.33);
  float b = 0.45 * square / (square + 0.09);
  return a + b * max(across, 0.0) / max(toward_light, toward_eye);
}

// The part of the light that a surface reflects to all sides after one bounce, for one direction; the paper's E, with its
// last term written without a division by mu.
float one_bounce(float a, float b, float mu) {
  float s = sqrt(1.0 - mu * mu);
  float g = s * (acos(mu) - s * mu) + 2.0 / 3.0 * (s * mu * (1.0 + s + s * s) / (1.0 + s) - s);
  return a + b / pi * g;
}

vec3 energy_preserving(float roughness, vec3 albedo, float toward_light, float toward_eye, float across) {
  float a = 1.0 / (1.0 + (0.5 - 2.0 / (3.0 * pi)) * roughness);
  float b = a * roughness;
  float single = a + b * (across > 0.0 ? across / max(toward_light, toward_eye) : across);
  float mean = a + (2.0 / 3.0 - 28.0 / (15.0 * pi)) * b;
  vec3 bounced = albedo * albedo * mean / (1.0 - albedo * (1.0 - mean));
  float lost = max(1.0 - one_bounce(a, b, toward_light), 0.0) * max(1.0 - one_bounce(a, b, toward_eye), 0.0);
  return albedo * single + bounced * (lost / max(1.0 - mean, 1e-6));
}

vec3 diffuse(Properties p, Surface s, Light l) {
  float toward_light = min(dot(s.normal, l.direction), 1.0);
  if (toward_light <= 0.0) return vec3(0);
  float toward_eye = clamp(dot(s.normal, s.to_eye), 0.0, 1.0);
  float across = dot(l.direction, s.to_eye) - toward_light * toward_eye;
  vec3 reflected = p.model == 0 ? s.diffuse_color * qualitative(p.sigma, toward_light, toward_eye, across)
                                : energy_preserving(p.roughness, s.diffuse_color, toward_light, toward_eye, across);
  return reflected * l.radiance * toward_light;
}
