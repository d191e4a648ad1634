// The view being drawn. View space is right-handed, the eye looks along -z, lengths are world units.

layout(std140, binding = 0) uniform LumenFrame {
  mat4 view;               // world to view space
  mat4 projection;         // view space to clip space
  vec4 unproject;          // view-space xy at depth 1 (perspective) or anywhere (orthographic) = uv * unproject.xy + unproject.zw
  vec4 size;               // pixels of the layers (border included), border, layers' pixels across one of the picture (antialiasing: 2)
  vec4 extent;             // near and far of the scene's sphere along the axis, its radius, 1 = orthographic
  vec4 transparent_extent; // near and far of the transparent surfaces along the axis, pixels per world unit at depth 1 (orthographic: anywhere), time in seconds
} lumen;

// A pixel of a full-screen pass.
struct Pixel {
  vec2 uv;          // 0..1 over the layers, origin bottom left
  ivec2 coordinate; // of the pixel, origin bottom left
};

bool orthographic() { return lumen.extent.w > 0.5; }

// View-space position of a pixel at an eye-space depth.
vec3 position_from(vec2 uv, float depth) {
  vec2 plane = uv * lumen.unproject.xy + lumen.unproject.zw;
  return vec3(orthographic() ? plane : plane * depth, -depth);
}

// Where a view-space position lands on the layers, 0..1.
vec2 uv_of(vec3 position) {
  vec2 plane = orthographic() ? position.xy : position.xy / -position.z;
  return (plane - lumen.unproject.zw) / lumen.unproject.xy;
}

// Toward the eye, unit.
vec3 to_eye(vec3 position) { return orthographic() ? vec3(0, 0, 1) : normalize(-position); }

// Scene depth: 0 at the near end of the scene's sphere, 1 at its far end.
float scene_depth(float depth) { return (depth - lumen.extent.x) / (lumen.extent.y - lumen.extent.x); }

// A length in pixels of the picture as one in pixels of the layers: for widths that shall not depend on antialiasing.
float layer_pixels(float length) { return length * lumen.size.w; }

// World units to pixels of the layers at an eye-space depth.
float pixels_of(float world, float depth) { return world * lumen.transparent_extent.z / (orthographic() ? 1.0 : depth); }
