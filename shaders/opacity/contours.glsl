// Opaque along contours and suggestive contours. DeCarlo, Finkelstein, Rusinkiewicz, Santella, Suggestive Contours for Conveying Shape,
// SIGGRAPH 2003; as opacity, Lawonn, Gasteiger, Preim, Adaptive Surface Visualization of Vessels with Animated Blood Flow, CGF 2014;
// contours of even width, Kindlmann, Whitaker, Tasdizen, Moeller, Curvature-Based Transfer Functions, VIS 2003.
// Inputs: position, normal, eye. Output: 0..1.
#include "lib/frame.glsl"
#include "lib/surface.glsl"

// Curvature in the direction of the eye along the surface, positive where it bends away: how the normal turns over a step of the
// position, both from the screen. Within a triangle this is the finite difference of its corners' normals; 0 where they are equal.
float radial_curvature(vec3 position_x, vec3 position_y, vec3 normal_x, vec3 normal_y, vec3 along) {
  float xx = dot(position_x, position_x), xy = dot(position_x, position_y), yy = dot(position_y, position_y);
  float x = dot(along, position_x), y = dot(along, position_y);
  vec2 step = vec2(yy * x - xy * y, xx * y - xy * x) / max(xx * yy - xy * xy, 1e-30);
  vec3 moved = step.x * position_x + step.y * position_y;
  return dot(step.x * normal_x + step.y * normal_y, moved) / max(dot(moved, moved), 1e-30);
}

float opacity(Properties p, Surface s) {
  vec3 position_x = dFdx(s.position), position_y = dFdy(s.position), normal_x = dFdx(s.normal), normal_y = dFdy(s.normal);
  float facing = clamp(dot(s.normal, s.to_eye), 0.0, 1.0);
  vec3 along = s.to_eye - facing * s.normal;
  // Where the normal was turned toward the eye at one pixel and not at its neighbor, the contour runs between them.
  bool turned = max(dot(normal_x, normal_x), dot(normal_y, normal_y)) > 1.0;
  float curvature = radial_curvature(position_x, position_y, normal_x, normal_y, along) * (s.front ? 1.0 : -1.0);

  // On a ball of this curvature, the distance to the contour as the screen shows it; parts that are inside out have contours, too.
  float away = pixels_of((1.0 - length(along)) / max(abs(curvature), 1e-20), -s.position.z);
  float contour = turned ? min(p.thickness, 1.0) : clamp(p.thickness + 0.5 - away, 0.0, 1.0);
  if (facing <= 0.0) contour = min(p.thickness, 1.0);

  float bend = -curvature * lumen.extent.z / p.cut_off;
  float slope = degrees(acos(facing));
  float near_contour = turned || !s.front ? 0.0 : smoothstep(1.0, 2.0, bend) * smoothstep(p.angle, p.angle + 10.0, slope);
  return mix(p.alpha_min, p.alpha_max, max(contour, p.suggestive * near_contour));
}
