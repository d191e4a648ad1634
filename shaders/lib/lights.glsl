// The view's lights, in view space.
#include "lib/surface.glsl"

struct LumenLight {
  vec4 place;  // xyz: toward the light, unit (directional) or where it is (point); w: 1 = point
  vec4 color;  // rgb: color * intensity; w: falloff, 0 none, 1 linear, 2 quadratic
};

layout(std140, binding = 1) uniform LumenLights {
  ivec4 lumen_light_count;  // x; programs are made for a number of lights
  LumenLight lumen_lights[16];
};

// A light that is known to be directional: the same everywhere.
Light directional_light(int index) { return Light(index, lumen_lights[index].place.xyz, lumen_lights[index].color.rgb); }

// A light that is known to be a point.
Light point_light(int index, vec3 position) {
  LumenLight source = lumen_lights[index];
  vec3 path = source.place.xyz - position;
  float range = length(path);
  float falloff = source.color.w < 0.5 ? 1.0 : (source.color.w < 1.5 ? range : range * range);
  return Light(index, path / max(range, 1e-20), source.color.rgb / max(falloff, 1e-20));
}

Light light_at(int index, vec3 position) {
  if (lumen_lights[index].place.w > 0.5) return point_light(index, position);
  return directional_light(index);
}
