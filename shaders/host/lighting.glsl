// The fused lighting of all opaque surfaces of a view; the host puts host/styles.glsl before, and adds shade() and the outputs.
#include "lib/frame.glsl"
#include "lib/surface.glsl"

// The surface that a pixel shows, from the layers.
Surface surface_at(vec2 uv) {
  vec4 packed_normal = textureLod(lumen_layer_normal, uv, 0.0);
  Surface s;
  s.position = position_from(uv, textureLod(lumen_layer_depth, uv, 0.0).r);
  s.normal = packed_normal.xyz;
  s.to_eye = to_eye(s.position);
  s.style = int(packed_normal.w + 0.5);
  s.instance = lumen_styles[s.style].variant.y;
  s.part = 0;
  s.primitive = 0;
  s.front = true;
  s.curvature = mat3(0);
  return s;
}
