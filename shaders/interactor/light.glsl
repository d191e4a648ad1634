// A light's sphere: circles of equal angle to the light, every 30 degrees, the one at 90, between lit and dark, stronger;
// a dot where it shines from, hollow behind the picture's plane. Inputs: color; toward, the light in view space. Output: color.
#include "lib/frame.glsl"

const float share = 0.45;     // of the view's shorter side: the radius
const float dot_radius = 6.0; // pixels

// How much of a pixel a line covers that is so far away and so wide, both in pixels.
float stroke(float distance, float width) { return clamp(0.5 * width + 0.5 - distance, 0.0, 1.0); }

// x: the line, y: its dark margin, which keeps it visible over bright pictures.
vec2 inked(float distance, float width, float strength) { return strength * vec2(stroke(distance, width), 0.5 * stroke(distance, width + 2.0)); }

vec2 sphere_lines(vec2 place, vec3 light, float radius) {
  float squared = dot(place, place);
  vec2 ink = inked(abs(sqrt(squared) - 1.0) * radius, 1.5, 0.9);
  float angle = acos(clamp(dot(vec3(place, sqrt(max(1.0 - squared, 0.0))), light), -1.0, 1.0)) / radians(30.0);
  float slope = max(fwidth(angle), 1e-6), nearest = round(angle);
  if (squared >= 1.0 || nearest == 0.0 || nearest == 6.0) return ink;  // those two are points
  // Toward the rim the circles run together.
  float strength = (nearest == 3.0 ? 0.9 : 0.4) * clamp(2.0 - 8.0 * slope, 0.0, 1.0);
  return max(ink, inked(abs(angle - nearest) / slope, 1.5, strength));
}

vec4 render(Properties p, Pixel pixel) {
  vec2 size = lumen.size.xy;
  float radius = share * (min(size.x, size.y) - 2.0 * lumen.size.z);
  vec2 place = (vec2(pixel.coordinate) + 0.5 - 0.5 * size) / radius;
  vec3 light = toward_at(vec2(0.5)).xyz;
  vec2 ink = sphere_lines(place, light, radius);
  float to_dot = length(place - light.xy) * radius;
  bool behind = light.z < 0.0;
  ink = max(ink, behind ? inked(abs(to_dot - dot_radius), 2.0, 1.0) : inked(to_dot, 2.0 * dot_radius, 1.0));
  vec4 scene = color_at(pixel.uv);
  scene = vec4(scene.rgb * (1.0 - ink.y), scene.a + (1.0 - scene.a) * ink.y);
  return mix(scene, vec4(1), ink.x);
}
