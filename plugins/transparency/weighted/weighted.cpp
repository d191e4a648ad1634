/// Order-independent transparency by weighted sums: one drawing of the surfaces, any order, any number of layers.
/// McGuire, Bavoil, Weighted Blended Order-Independent Transparency, JCGT 2013.

#include <lumen/transparency.h>

namespace {

struct Weighted : lumen::Transparency {
  using Transparency::Transparency;

  lumen::Property<lumen::Choice> weight{this, "weight", {"normalized"}, {.doc = "how depth weighs: over the transparent surfaces' extent, not at all, or equations 7 to 10 of the paper, which want depths of 0.1 to 500", .choices = {"normalized", "none", "eq7", "eq8", "eq9", "eq10"}, .constant = true}};
  lumen::Property<float> decay{this, "decay", 4.0f, {.min = 0, .max = 20, .doc = "how strongly near surfaces outweigh far ones: exp(-decay z), z = 0 at the nearest, 1 at the farthest", .when = "weight = normalized"}};

  lumen::Writes transparent{this, "transparent", lumen::Format::RGBA32F};

  void render(lumen::TransparencyFrame& frame) override {
    constexpr const char* shader = "transparency/weighted.glsl";
    const auto& sum = frame.scratch("sum", lumen::Format::RGBA32F, frame.size());
    const auto& revealage = frame.scratch("revealage", lumen::Format::R32F, frame.size());
    frame.surfaces(shader, {.function = "store",
                            .targets = {{&sum, "sum", lumen::Blend::add, glm::vec4(0)},
                                        {&revealage, "revealage", lumen::Blend::multiply_by_one_minus_source, glm::vec4(1)}}});
    frame.fullscreen(shader, {.function = "resolve", .inputs = {{"sum", &sum}, {"revealage", &revealage}}});
  }
};

}  // namespace

LUMEN_PLUGIN(Weighted, "transparency.weighted", "Transparency by weighted sums, whatever the order. McGuire, Bavoil, Weighted Blended Order-Independent Transparency, JCGT 2013.")
