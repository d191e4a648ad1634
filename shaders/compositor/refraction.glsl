// The opaque scene as the front-most transparent surface bends it. Wyman, An Approximate Image-Space Approach for Interactive
// Refraction, SIGGRAPH 2005, with a given thickness instead of the back faces' depth.
// Inputs: color, opaque, transparent, depth, front depth and normal. Output: color.
#include "lib/frame.glsl"

// Where the ray through a pixel leaves the surface, in the picture.
vec2 bent(Properties p, vec2 uv) {
  vec3 position = position_from(uv, front_depth_at(uv));
  vec3 ray = -to_eye(position);
  vec3 inside = refract(ray, front_normal_at(uv), 1.0 / p.index);
  // From the same depth on both rays go straight: what lies right behind the surface is not moved.
  float along = min(p.thickness * lumen.extent.z, max(depth_at(uv) - front_depth_at(uv), 0.0));
  return uv_of(position + inside * (along / max(-inside.z, 1e-3) * -ray.z));
}

vec4 render(Properties p, Pixel pixel) {
  vec4 scene = color_at(pixel.uv);
  float clear = 1.0 - transparent_at(pixel.uv).a;
  if (clear >= 1.0 || front_depth_at(pixel.uv) >= depth_at(pixel.uv)) return scene;
  vec2 uv = clamp(bent(p, pixel.uv), vec2(0), vec2(1));
  // What is bent must lie behind the surface: nothing in front of it is seen through it.
  if (depth_at(uv) < front_depth_at(pixel.uv)) return scene;
  // Where nothing moves the antialiased picture stays.
  if (distance(uv, pixel.uv) * lumen.size.y < 0.5) return scene;
  return transparent_at(pixel.uv) + clear * opaque_at(uv);
}
