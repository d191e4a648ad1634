// Darkens the picture where a light does not reach: shadow map, Williams, SIGGRAPH 1978; percentage-closer filtering, Reeves,
// Salesin, Cook, SIGGRAPH 1987. Inputs: color, depth, normal, transparent. Output: color; alpha as it was.
#include "lib/lights.glsl"
#include "lib/frame.glsl"

struct Receiver {
  vec3 position, normal;  // as the light sees them
  float width;            // of the light's picture, at distance 1 if it is a point
  bool parallel;
  float bias;             // world
};

vec4 column(int i) { return seen_from_at(vec2((float(i) + 0.5) / 5.0, 0.5)); }

// Where a position is on the map, 0..1.
vec2 map_uv(Receiver r, vec3 position) { return (r.parallel ? position.xy : position.xy / -position.z) / r.width + 0.5; }

// 1 if nothing is in front of the receiver's tangent plane there: taps on the plane itself are never in shadow, however steep.
float lit_texel(Receiver r, vec2 uv) {
  vec2 plane = (uv - 0.5) * r.width;
  float height = dot(r.normal, r.position), own;
  if (r.parallel) own = (dot(r.normal.xy, plane) - height) / max(r.normal.z, 0.05);
  else own = height / min(dot(r.normal, vec3(plane, -1)), -0.05);
  return shadow_map_at(uv) < own - r.bias ? 0.0 : 1.0;
}

// Four texels, weighted by how near they are.
float lit_at(Receiver r, vec2 uv) {
  if (any(greaterThan(abs(uv - 0.5), vec2(0.5)))) return 1.0;
  vec2 texel = 1.0 / vec2(textureSize(shadow_map, 0));
  vec2 corner = uv / texel - 0.5, part = fract(corner);
  vec2 first = (floor(corner) + 0.5) * texel;
  return mix(mix(lit_texel(r, first), lit_texel(r, first + vec2(texel.x, 0)), part.x),
             mix(lit_texel(r, first + vec2(0, texel.y)), lit_texel(r, first + texel), part.x), part.y);
}

// The part of the light that reaches the receiver.
float lit(Properties p, Receiver r, float softness) {
  const vec2 golden = vec2(-0.73736888, 0.67549029);  // cosine and sine of the golden angle
  vec2 center = map_uv(r, r.position);
  float radius = softness / (r.width * (r.parallel ? 1.0 : -r.position.z));
  if (radius * float(textureSize(shadow_map, 0).x) < 0.5) return lit_at(r, center);
  vec2 around = vec2(1, 0);
  float sum = 0.0;
  for (int i = 0; i < p.samples; ++i) {
    sum += lit_at(r, center + around * (radius * sqrt((float(i) + 0.5) / float(p.samples))));
    around = vec2(around.x * golden.x - around.y * golden.y, around.x * golden.y + around.y * golden.x);
  }
  return sum / float(p.samples);
}

float shadow(Properties p, vec2 uv) {
  float depth = depth_at(uv);
  if (isinf(depth)) return 0.0;
  vec3 position = position_from(uv, depth), normal = normal_at(uv);
  // Toward the terminator the light fades by itself; what faces away is in the surface's own shadow.
  float facing = smoothstep(0.0, 0.15, dot(normal, light_at(p.light, position).direction));
  if (facing <= 0.0) return 1.0;
  mat4 to_light = mat4(column(0), column(1), column(2), column(3));
  Receiver r;
  r.width = column(4).x;
  r.parallel = column(4).y > 0.5;
  r.position = (to_light * vec4(position, 1)).xyz;
  r.normal = mat3(to_light) * normal;
  if (!r.parallel && r.position.z >= 0.0) return 1.0 - facing;
  float softness = p.softness * lumen.extent.z;
  float texel = r.width / float(textureSize(shadow_map, 0).x) * (r.parallel ? 1.0 : -r.position.z);
  r.bias = p.bias * texel + 0.2 * softness;
  r.position += r.normal * (p.bias * texel);
  return 1.0 - facing * lit(p, r, softness);
}

vec4 render(Properties p, Pixel pixel) {
  vec4 scene = color_at(pixel.uv), front = transparent_at(pixel.uv);
  vec3 behind = max(scene.rgb - front.rgb, 0.0);
  float dark = p.strength * shadow(p, pixel.uv);
  return vec4(scene.rgb - dark * behind * (1.0 - p.color), scene.a);
}

vec4 unshadowed(Properties p, Pixel pixel) { return color_at(pixel.uv); }
