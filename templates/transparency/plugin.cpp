/// The mean color of all transparent layers, whatever their order. Bavoil, Myers, 2008.

#include <lumen/transparency.h>

namespace {

struct @Class@ : lumen::Transparency {
  using Transparency::Transparency;

  lumen::Property<float> gain{this, "gain", 1.0f, {.min = 0, .max = 4, .doc = "multiplies the color"}};
  lumen::Writes transparent{this, "transparent", lumen::Format::RGBA32F};

  void render(lumen::TransparencyFrame& frame) override {
    constexpr const char* shader = "transparency/@name@.glsl";
    const auto& sum = frame.scratch("sum", lumen::Format::RGBA32F, frame.size());
    const auto& revealage = frame.scratch("revealage", lumen::Format::R32F, frame.size());
    frame.surfaces(shader, {.function = "store",
                            .targets = {{&sum, "sum", lumen::Blend::add, glm::vec4(0)},
                                        {&revealage, "revealage", lumen::Blend::multiply_by_one_minus_source, glm::vec4(1)}}});
    frame.fullscreen(shader, {.function = "resolve", .inputs = {{"sum", &sum}, {"revealage", &revealage}}});
  }
};

}  // namespace

LUMEN_PLUGIN(@Class@, "transparency.@name@", "The mean color of all transparent layers, whatever their order. Bavoil, Myers, 2008.")
