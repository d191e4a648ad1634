/// A surface that fades to a ghost about a place and is opaque elsewhere; the ghost keeps its silhouettes. Bruckner, Groeller,
/// VolumeShop: An Interactive System for Direct Volume Illustration, IEEE Visualization 2005: background, ghost and selection, by
/// degrees of membership.

#include <lumen/term.h>

namespace {

struct Ghost : lumen::Opacity {
  using Opacity::Opacity;

  lumen::Property<glm::vec3> center{this, "center", glm::vec3(0), {.unit = "world", .doc = "of the ghost: a place, or linked to what shall be seen, a volume's center say"}};
  lumen::Property<float> radius{this, "radius", 0.4f, {.min = 0, .max = 10, .unit = "scene radii", .doc = "where a point belongs to the ghost and to the background by halves"}};
  lumen::Property<float> softness{this, "softness", 0.3f, {.min = 0, .max = 1, .unit = "radii", .doc = "over how much more and less the membership falls from 1 to 0"}};
  lumen::Property<float> faintest{this, "faintest", 0.05f, {.min = 0, .max = 1, .doc = "opacity of the ghost where it faces the eye"}};
  lumen::Property<float> features{this, "features", 0.9f, {.min = 0, .max = 1, .doc = "opacity of the ghost along its silhouettes"}};
  lumen::Property<float> sharpness{this, "sharpness", 3.0f, {.min = 0.1, .max = 20, .doc = "how close to the silhouettes the features stay", .logarithmic = true}};
  lumen::Property<float> background{this, "background", 1.0f, {.min = 0, .max = 1, .doc = "opacity of what does not belong to the ghost"}};
};

}  // namespace

LUMEN_PLUGIN(Ghost, "opacity.ghost", "Opaque, but a ghost about a place, whose silhouettes stay. Bruckner, Groeller, VolumeShop: An Interactive System for Direct Volume Illustration, IEEE Visualization 2005.")
