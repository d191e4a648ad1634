/// Clear like glass, but for edges and highlights, which hide what is behind them. Behrendt, Berg, Beuing, Preim, Saalfeld, Explorative Blood Flow Visualization Using Dynamic Line Filtering Based on Surface Features, CGF 2018.

#include <lumen/term.h>

namespace {

struct Glass : lumen::Opacity {
  using Opacity::Opacity;

  lumen::Property<float> falloff{this, "falloff", 1.0f, {.min = 0.01, .max = 10, .doc = "how narrow the clear middle is; small values leave only the edge opaque", .logarithmic = true}};
  lumen::Property<float> alpha_min{this, "alpha_min", 0.0f, {.min = 0, .max = 1, .doc = "opacity where the surface faces the eye and no highlight is"}};
  lumen::Property<float> alpha_max{this, "alpha_max", 0.8f, {.min = 0, .max = 1, .doc = "opacity at the edge"}};
  lumen::Property<float> highlights{this, "highlights", 1.0f, {.min = 0, .max = 10, .doc = "opacity of a highlight in white light of intensity 1; 0 is the edge alone"}};
  lumen::Property<float> shininess{this, "shininess", 40.0f, {.min = 1, .max = 1000, .doc = "how small highlights are", .logarithmic = true}};
};

}  // namespace

LUMEN_PLUGIN(Glass, "opacity.glass", "Clear like glass, but for edges and highlights, which hide what is behind them. Behrendt, Berg, Beuing, Preim, Saalfeld, Explorative Blood Flow Visualization Using Dynamic Line Filtering Based on Surface Features, CGF 2018.")
