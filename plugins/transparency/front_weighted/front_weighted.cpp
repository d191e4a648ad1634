/// The front layer exact, what lies behind it by weighted sums: most of what one sees is in front.
/// The front as in depth peeling (Everitt, Interactive Order-Independent Transparency, NVIDIA 2001), the tail after McGuire, Bavoil, JCGT 2013.

#include <limits>

#include <lumen/transparency.h>

namespace {

struct FrontWeighted : lumen::Transparency {
  using Transparency::Transparency;

  lumen::Property<float> decay{this, "decay", 4.0f, {.min = 0, .max = 20, .doc = "how strongly near surfaces outweigh far ones behind the front: exp(-decay z), z = 0 at the nearest, 1 at the farthest"}};

  lumen::Writes transparent{this, "transparent", lumen::Format::RGBA32F};

  void render(lumen::TransparencyFrame& frame) override {
    constexpr const char* shader = "transparency/front_weighted.glsl";
    const auto& nearest = frame.scratch("nearest", lumen::Format::R32F, frame.size());
    const auto& front = frame.scratch("front", lumen::Format::RGBA32F, frame.size());
    const auto& sum = frame.scratch("sum", lumen::Format::RGBA32F, frame.size());
    const auto& revealage = frame.scratch("revealage", lumen::Format::R32F, frame.size());
    frame.surfaces(shader, {.function = "find",
                            .targets = {{&nearest, "nearest", lumen::Blend::maximum, glm::vec4(-std::numeric_limits<float>::infinity())}},
                            .lit = false});
    frame.surfaces(shader, {.function = "store",
                            .targets = {{&front, "front", lumen::Blend::under, glm::vec4(0)},
                                        {&sum, "sum", lumen::Blend::add, glm::vec4(0)},
                                        {&revealage, "revealage", lumen::Blend::multiply_by_one_minus_source, glm::vec4(1)}},
                            .inputs = {{"nearest", &nearest}}});
    frame.fullscreen(shader, {.function = "resolve", .inputs = {{"front", &front}, {"sum", &sum}, {"revealage", &revealage}}});
  }
};

}  // namespace

LUMEN_PLUGIN(FrontWeighted, "transparency.front_weighted", "The front layer exact, the layers behind it by weighted sums; exact for two layers. Everitt, Interactive Order-Independent Transparency, NVIDIA 2001; McGuire, Bavoil, Weighted Blended Order-Independent Transparency, JCGT 2013.")
