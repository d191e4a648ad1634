// Opaque along contours and suggestive contours. DeCarlo, Finkelstein, Rusinkiewicz, Santella, Suggestive Contours for Conveying Shape,
// SIGGRAPH 2003; as opacity, Lawonn, Gasteiger, Preim, Adaptive Surface Visualization of Vessels with Animated Blood Flow, CGF 2014;
// contours of even width, Kindlmann, Whitaker, Tasdizen, Moeller, Curvature-Based Transfer Functions, VIS 2003.
// Inputs: position, normal, eye, curvature. Output: 0..1.
#include "lib/frame.glsl"
#include "lib/surface.glsl"

// How the position changes with the pixel.
struct Footprint {
  vec3 x, y;
};

// The step on the screen, in pixels, that goes along a vector of the surface.
vec2 step_along(Footprint f, vec3 along) {
  float xx = dot(f.x, f.x), xy = dot(f.x, f.y), yy = dot(f.y, f.y);
  float x = dot(along, f.x), y = dot(along, f.y);
  return vec2(yy * x - xy * y, xx * y - xy * x) / max(xx * yy - xy * xy, 1e-30);
}

// Curvature in the direction of the eye along the surface, positive where it bends away: how the normal turns over a step of the
// position, both from the screen. Within a triangle this is the finite difference of its corners' normals; 0 where they are equal.
float radial_curvature(Footprint f, vec3 normal_x, vec3 normal_y, vec3 along) {
  vec2 step = step_along(f, along);
  vec3 moved = step.x * f.x + step.y * f.y;
  return dot(step.x * normal_x + step.y * normal_y, moved) / max(dot(moved, moved), 1e-30);
}

// Without the surface's curvature: the regions that bend in along the view, which suggestive contours bound.
float bent_in(Properties p, float curvature) { return smoothstep(1.0, 2.0, -curvature * lumen.extent.z / p.cut_off); }

// With it: lines where the radial curvature is 0 and grows toward the eye by at least the cut-off. `slope`: of the radial curvature, per pixel.
float line_of_inflection(Properties p, Footprint f, float curvature, vec2 slope, vec3 along, float thickness) {
  vec2 step = step_along(f, along);
  vec3 moved = step.x * f.x + step.y * f.y;
  float growth = dot(slope, step) * inversesqrt(max(dot(moved, moved), 1e-30)) * lumen.extent.z * lumen.extent.z;
  float away = abs(curvature) / max(length(slope), 1e-30);
  return smoothstep(1.0, 2.0, growth / p.cut_off) * min(thickness, clamp(0.5 * thickness + 0.5 - away, 0.0, 1.0));
}

float opacity(Properties p, Surface s) {
  Footprint f = Footprint(dFdx(s.position), dFdy(s.position));
  vec3 normal_x = dFdx(s.normal), normal_y = dFdy(s.normal);
  float facing = clamp(dot(s.normal, s.to_eye), 0.0, 1.0);
  vec3 along = s.to_eye - facing * s.normal;
  // Where the normal was turned toward the eye at one pixel and not at its neighbor, the contour runs between them.
  bool turned = max(dot(normal_x, normal_x), dot(normal_y, normal_y)) > 1.0;
  float bend = radial_curvature(f, normal_x, normal_y, along) * (s.front ? 1.0 : -1.0);

  float thickness = layer_pixels(p.thickness);
  // On a ball of this curvature, the distance to the contour as the screen shows it; parts that are inside out have contours, too.
  float away = pixels_of((1.0 - length(along)) / max(abs(bend), 1e-20), -s.position.z);
  float contour = turned ? min(thickness, 1.0) : clamp(thickness + 0.5 - away, 0.0, 1.0);
  if (facing <= 0.0) contour = min(thickness, 1.0);

  float curvature = dot(along, s.curvature * along) / max(dot(along, along), 1e-30);
  vec2 slope = vec2(dFdx(curvature), dFdy(curvature));
  float suggestive = s.curvature == mat3(0) ? bent_in(p, bend) : line_of_inflection(p, f, curvature, slope, along, thickness);
  suggestive *= turned || !s.front ? 0.0 : smoothstep(p.angle, p.angle + 10.0, degrees(acos(facing)));
  return mix(p.alpha_min, p.alpha_max, max(contour, p.suggestive * suggestive));
}
