// Ambient occlusion from a hemisphere of samples around the normal, dense near its center, turned per pixel.
// Mittring, Finding Next Gen: CryEngine 2, SIGGRAPH 2007 courses; Ostendorf 2021, section 3.7.
// Inputs: depth, normal. Output: occlusion = 1 - visibility.
#include "lib/frame.glsl"

// One of 16 angles, each once in every 4x4 pixels.
float turn_of(ivec2 pixel) {
  int index = (pixel.x & 3) * 4 + (pixel.y & 3);
  return 6.2831853 * fract(float(index) * 0.61803399);
}

vec4 occlusion(Properties p, Pixel pixel) {
  const vec2 golden = vec2(-0.73736888, 0.67549029);  // cosine and sine of the golden angle
  float depth = depth_at(pixel.uv);
  vec3 position = position_from(pixel.uv, depth);
  vec3 normal = normal_at(pixel.uv);
  vec3 tangent = normalize(abs(normal.z) > 0.5 ? vec3(normal.z, 0, -normal.x) : vec3(-normal.y, normal.x, 0));
  vec3 bitangent = cross(normal, tangent);
  float radius = p.radius * lumen.extent.z;
  float turn = turn_of(pixel.coordinate);
  vec2 around = vec2(cos(turn), sin(turn));
  float occluded = 0.0, seen = 0.0;
  for (int i = 0; i < p.samples; ++i) {
    float up = (float(i) + 0.5) / float(p.samples);
    float reach = fract(float(i) * 0.75487767 + 0.5);
    vec3 direction = (tangent * around.x + bitangent * around.y) * sqrt(1.0 - up * up) + normal * up;
    around = vec2(around.x * golden.x - around.y * golden.y, around.x * golden.y + around.y * golden.x);
    vec3 point = position + direction * (radius * mix(0.05, 1.0, reach * reach));
    vec2 uv = (floor(uv_of(point) * lumen.size.xy) + 0.5) / lumen.size.xy;
    if (any(greaterThan(abs(uv - 0.5), vec2(0.5)))) continue;
    seen += 1.0;
    // The sample slides to the pixel's center at its height over the surface, so that a plane never occludes itself.
    vec2 plane = uv * lumen.unproject.xy + lumen.unproject.zw;
    float height = dot(normal, point);
    float own = orthographic() ? (dot(normal.xy, plane) - height) / max(normal.z, 1e-3)
                               : height / min(dot(normal, vec3(plane, -1)), -1e-4);
    float stored = depth_at(uv);
    if (stored <= own - p.bias * radius) occluded += smoothstep(0.0, 1.0, radius / max(abs(depth - stored), 1e-20));
  }
  float visibility = pow(1.0 - occluded / max(seen, 1.0), p.strength);
  return vec4(1.0 - visibility);
}

// The mean over the 4x4 pixels that hold every angle once, of those on the same surface.
vec4 smoothed(Properties p, Pixel pixel) {
  float depth = depth_at(pixel.uv);
  float reach = p.radius * lumen.extent.z;
  float sum = 0.0, weight = 0.0;
  for (int y = -2; y < 2; ++y) {
    for (int x = -2; x < 2; ++x) {
      vec2 uv = pixel.uv + vec2(x, y) / lumen.size.xy;
      float near = abs(depth_at(uv) - depth) <= reach ? 1.0 : 0.0;
      sum += near * raw_at(uv);
      weight += near;
    }
  }
  return vec4(sum / max(weight, 1.0));
}
