/// Toon bands that lose detail with distance, toward silhouettes or away from highlights. Barla, Thollot, Markosian, X-Toon: An Extended Toon Shader, NPAR 2006; its image is two transfer functions, blended over the axis of detail.

#include <lumen/term.h>

namespace {

using lumen::TransferFunction;

/// Grays from dark to lit, each edge a short ramp.
TransferFunction bands(const std::vector<float>& levels, const std::vector<float>& edges) {
  constexpr float ramp = 0.01f;
  TransferFunction function;
  const auto add = [&](float x, float level) { function.points.push_back({x, glm::vec4(glm::vec3(level), 1)}); };
  add(0, levels.front());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    add(edges[i] - ramp, levels[i]);
    add(edges[i] + ramp, levels[i + 1]);
  }
  add(1, levels.back());
  return function;
}

struct XToon : lumen::Diffuse {
  using Diffuse::Diffuse;

  lumen::Property<TransferFunction> fine{this, "fine", bands({0.08f, 0.25f, 0.5f, 0.8f, 1}, {0.08f, 0.3f, 0.6f, 0.93f}), {.doc = "light over N.L where there is full detail; a range from -1 reaches the side away from the light"}};
  lumen::Property<TransferFunction> coarse{this, "coarse", bands({0.6f, 0.8f}, {0.25f}), {.doc = "light over N.L where there is no detail"}};
  lumen::Property<lumen::Choice> detail{this, "detail", lumen::Choice{"depth"}, {.doc = "what detail follows: nearness to the eye, facing the eye, or nearness to the mirrored light", .choices = {"depth", "silhouette", "highlight"}}};
  lumen::Property<float> nearest{this, "nearest", 0.1f, {.min = -1, .max = 2, .unit = "scene depth", .doc = "where detail begins to fade; 0 is the scene's near end, 1 its far end", .when = "detail = depth"}};
  lumen::Property<float> farthest{this, "farthest", 0.9f, {.min = -1, .max = 2, .unit = "scene depth", .doc = "where no detail is left", .when = "detail = depth"}};
  lumen::Property<float> power{this, "power", 1.0f, {.min = 0.05, .max = 100, .doc = "how fast detail fades toward the silhouette or away from the highlight", .when = "detail != depth", .logarithmic = true}};
};

}  // namespace

LUMEN_PLUGIN(XToon, "diffuse.x_toon", "Toon bands that lose detail with distance, toward silhouettes or away from highlights. Barla, Thollot, Markosian, X-Toon: An Extended Toon Shader, NPAR 2006; its image is two transfer functions, blended over the axis of detail.")
