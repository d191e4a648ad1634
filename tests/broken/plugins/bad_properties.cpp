/// Properties that contradict themselves.
#include <lumen/term.h>

namespace {

struct BadProperties : lumen::Ambient {
  using Ambient::Ambient;
  lumen::Property<float> outside{this, "outside", 3.0f, {.min = 0, .max = 1, .doc = "a default beyond its range"}};
  lumen::Property<lumen::Choice> choice{this, "choice", {"third"}, {.doc = "a default that is no choice", .choices = {"first", "second"}}};
  lumen::Property<float> silent{this, "silent", 0.0f};
  lumen::Property<float> scale{this, "scale", 1.0f, {.min = 0, .max = 2, .doc = "zero has no logarithm", .logarithmic = true}};
  lumen::Property<float> waits{this, "waits", 1.0f, {.doc = "has an effect when something else is", .when = "nobody = 3"}};
};

}  // namespace

LUMEN_PLUGIN(BadProperties, "ambient.bad_properties", "Properties that contradict themselves.")
