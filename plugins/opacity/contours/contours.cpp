/// Opaque along contours and, on what faces outward, along suggestive contours: where the surface stops to bend in toward the eye. DeCarlo, Finkelstein, Rusinkiewicz, Santella, Suggestive Contours for Conveying Shape, SIGGRAPH 2003; as opacity of vessels, Lawonn, Gasteiger, Preim, CGF 2014.

#include <lumen/term.h>

namespace {

struct Contours : lumen::Opacity {
  using Opacity::Opacity;

  /// Of the surface: lines need it; a surface without shows the regions that they bound.
  lumen::Reads curvature{this, "curvature"};

  lumen::Property<float> thickness{this, "thickness", 3.0f, {.min = 0, .max = 100, .unit = "pixels", .doc = "width of contours, and of the lines of suggestive contours"}};
  lumen::Property<float> suggestive{this, "suggestive", 1.0f, {.min = 0, .max = 1, .doc = "opacity of suggestive contours over that of contours; 0 leaves the contours alone"}};
  lumen::Property<float> cut_off{this, "cut_off", 5.0f, {.min = 0.01, .max = 1000, .unit = "1 / scene radius^2", .doc = "how much the radial curvature must grow toward the eye, by the way, for a suggestive contour; full at twice that. Where the mesh has no curvature (filter.curvature), regions stand for the lines: those that bend in along the view by this many 1 / scene radius", .when = "suggestive", .logarithmic = true}};
  lumen::Property<float> angle{this, "angle", 25.0f, {.min = 0, .max = 80, .unit = "degrees", .doc = "no suggestive contours where the surface faces the eye up to this angle; full 10 degrees beyond", .when = "suggestive"}};
  lumen::Property<float> alpha_min{this, "alpha_min", 0.05f, {.min = 0, .max = 1, .doc = "opacity elsewhere"}};
  lumen::Property<float> alpha_max{this, "alpha_max", 1.0f, {.min = 0, .max = 1, .doc = "opacity of contours"}};
};

}  // namespace

LUMEN_PLUGIN(Contours, "opacity.contours", "Opaque along contours and, on what faces outward, along suggestive contours: lines where the surface stops to bend in toward the eye, of meshes with curvature (filter.curvature); of others, the regions that these lines bound. DeCarlo, Finkelstein, Rusinkiewicz, Santella, Suggestive Contours for Conveying Shape, SIGGRAPH 2003; as opacity of vessels, Lawonn, Gasteiger, Preim, CGF 2014.")
