/// Opaque along contours and, on what faces outward, where the surface nearly has one: suggestive contours, by the sign of the radial curvature. DeCarlo, Finkelstein, Rusinkiewicz, Santella, Suggestive Contours for Conveying Shape, SIGGRAPH 2003; as opacity of vessels, Lawonn, Gasteiger, Preim, CGF 2014.

#include <lumen/term.h>

namespace {

struct Contours : lumen::Opacity {
  using Opacity::Opacity;

  lumen::Property<float> thickness{this, "thickness", 3.0f, {.min = 0, .max = 100, .unit = "pixels", .doc = "width of the contour"}};
  lumen::Property<float> suggestive{this, "suggestive", 1.0f, {.min = 0, .max = 1, .doc = "opacity of suggestive contours over that of contours; 0 leaves the contours alone"}};
  lumen::Property<float> cut_off{this, "cut_off", 5.0f, {.min = 0.01, .max = 1000, .unit = "1 / scene radius", .doc = "how far the surface must bend in along the view to count as a suggestive contour; full at twice that", .when = "suggestive", .logarithmic = true}};
  lumen::Property<float> angle{this, "angle", 25.0f, {.min = 0, .max = 80, .unit = "degrees", .doc = "no suggestive contours where the surface faces the eye up to this angle; full 10 degrees beyond", .when = "suggestive"}};
  lumen::Property<float> alpha_min{this, "alpha_min", 0.05f, {.min = 0, .max = 1, .doc = "opacity elsewhere"}};
  lumen::Property<float> alpha_max{this, "alpha_max", 1.0f, {.min = 0, .max = 1, .doc = "opacity of contours"}};
};

}  // namespace

LUMEN_PLUGIN(Contours, "opacity.contours", "Opaque along contours and, on what faces outward, where the surface nearly has one: suggestive contours, by the sign of the radial curvature. DeCarlo, Finkelstein, Rusinkiewicz, Santella, Suggestive Contours for Conveying Shape, SIGGRAPH 2003; as opacity of vessels, Lawonn, Gasteiger, Preim, CGF 2014.")
