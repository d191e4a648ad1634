/// Transparency by moments: two drawings, a few numbers per pixel that tell how light is absorbed along the ray.
/// Muenstermann, Krumpen, Klein, Peters, Moment-Based Order-Independent Transparency, I3D 2018.

#include <limits>

#include <lumen/transparency.h>

namespace {

/// What the paper recommends for moments of 32 bits.
float bias_for(std::string_view moments) { return moments == "4" ? 5e-7f : moments == "6" ? 5e-6f : 5e-5f; }

struct Moments : lumen::Transparency {
  using Transparency::Transparency;

  lumen::Property<lumen::Choice> moments{this, "moments", {"8"}, {.doc = "how many power moments of the absorbance are kept; more resolve more layers", .choices = {"4", "6", "8"}, .constant = true}};
  lumen::Property<lumen::Choice> bounds{this, "bounds", {"pixel"}, {.doc = "what the moments' depths span: each pixel's own surfaces, found by another drawing without light, or all transparent surfaces, which is faster and less sharp", .choices = {"pixel", "surfaces"}, .constant = true}};
  lumen::Property<float> bias{this, "bias", bias_for("8"), {.min = 1e-8, .max = 1e-1, .doc = "how far the moments are drawn toward those of an even spread, against rounding; follows the number of moments unless set", .logarithmic = true}};
  lumen::Property<float> overestimation{this, "overestimation", 0.25f, {.min = 0, .max = 1, .doc = "share of a fragment's own place in the absorbance in front of it: 0 is the least that the moments allow, 1 the most"}};

  lumen::Writes transparent{this, "transparent", lumen::Format::RGBA32F};

  void changed(std::string_view property) override {
    if (property == "moments") bias.set_default(bias_for(moments->name));
  }

  void render(lumen::TransparencyFrame& frame) override {
    using lumen::Blend, lumen::Format;
    constexpr const char* shader = "transparency/moments.glsl";
    const auto scratch = [&](const char* name, Format format) { return &frame.scratch(name, format, frame.size()); };
    const auto* total = scratch("total", Format::R32F);
    const auto* low = scratch("low", Format::RGBA32F);
    const auto* sum = scratch("sum", Format::RGBA32F);
    const auto* revealage = scratch("revealage", Format::R32F);
    lumen::TextureInputs inputs;
    if (bounds->name == "pixel") {
      const auto* extent = scratch("extent", Format::RG32F);
      frame.surfaces(shader, {.function = "find", .targets = {{extent, "extent", Blend::maximum, glm::vec4(-std::numeric_limits<float>::infinity())}}, .lit = false});
      inputs.emplace_back("extent", extent);
    }
    std::vector<lumen::Target> targets = {{total, "total", Blend::add, glm::vec4(0)}, {low, "low", Blend::add, glm::vec4(0)}};
    const auto* high = moments->name == "4" ? nullptr : scratch("high", Format::RGBA32F);
    if (high != nullptr) targets.push_back({high, "high", Blend::add, glm::vec4(0)});
    const std::string variant = std::string(high == nullptr ? "_4" : "") + (inputs.empty() ? "" : "_in_pixel");
    frame.surfaces(shader, {.function = ("absorb" + variant).c_str(), .targets = std::move(targets), .inputs = inputs, .lit = false});
    inputs.insert(inputs.end(), {{"total", total}, {"low", low}});
    if (high != nullptr) inputs.emplace_back("high", high);
    frame.surfaces(shader, {.function = ("weigh" + variant).c_str(),
                            .targets = {{sum, "sum", Blend::add, glm::vec4(0)},
                                        {revealage, "revealage", Blend::multiply_by_one_minus_source, glm::vec4(1)}},
                            .inputs = inputs});
    frame.fullscreen(shader, {.function = "resolve", .inputs = {{"sum", sum}, {"revealage", revealage}}});
  }
};

}  // namespace

LUMEN_PLUGIN(Moments, "transparency.moments", "Transparency by 4, 6 or 8 power moments of the absorbance along the ray. Muenstermann, Krumpen, Klein, Peters, Moment-Based Order-Independent Transparency, I3D 2018.")
