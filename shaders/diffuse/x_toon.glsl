// Toon bands that lose detail. Barla, Thollot, Markosian, X-Toon: An Extended Toon Shader, NPAR 2006: tone across, detail upward in
// a map, here made of two transfer functions. Inputs: position, normal, eye, material, light. Output: radiance.
#include "lib/frame.glsl"
#include "lib/surface.glsl"

// 1 where z is zmin or less, 0 where it is zmax or more. Logarithmic under perspective, as sizes on screen are.
float nearness(Properties p, float z) {
  float first = mix(lumen.extent.x, lumen.extent.y, p.nearest), last = mix(lumen.extent.x, lumen.extent.y, p.farthest);
  if (!(last > first)) return z < first ? 1.0 : 0.0;
  float passed = orthographic() || first <= 0.0 ? (z - first) / (last - first) : log(max(z, first) / first) / log(last / first);
  return 1.0 - clamp(passed, 0.0, 1.0);
}

float detail_of(Properties p, Surface s, Light l) {
  if (p.detail == 0) return nearness(p, -s.position.z);
  float facing = p.detail == 1 ? dot(s.normal, s.to_eye) : max(dot(reflect(-l.direction, s.normal), s.to_eye), 0.0);
  return pow(clamp(abs(facing), 0.0, 1.0), p.power);
}

vec3 diffuse(Properties p, Surface s, Light l) {
  float tone = dot(s.normal, l.direction);
  return s.diffuse_color * l.radiance * mix(map(p.coarse, tone).rgb, map(p.fine, tone).rgb, detail_of(p, s, l));
}
