/// What the screen-space occlusions share: their common properties, refinement while idle, half resolution, and the blur.
#pragma once

#include <lumen/occlusion.h>

/// Its shader has `vec4 gather(Properties p, Pixel pixel)`, which returns gathered(...) of lib/occlusion.glsl.
class ScreenSpace : public lumen::Occlusion {
 public:
  struct Defaults {
    float radius = 0.1f;
    int refinements = 8;
  };
  ScreenSpace(lumen::Binding& binding, const char* shader, const Defaults& defaults)
      : Occlusion(binding),
        radius(this, "radius", defaults.radius,
               {.min = 0.001, .max = 4, .unit = "scene radii", .doc = "how far an occluder reaches; from 2 on, everything in the picture does", .logarithmic = true}),
        refinements(this, "refinements", defaults.refinements,
                    {.min = 1, .max = 256, .doc = "pictures with other samples that are averaged while the view rests", .logarithmic = true, .advanced = true}),
        shader_(shader) {}

  lumen::Property<float> radius;
  lumen::Property<bool> falloff{this, "falloff", true, {.doc = "an occluder counts less toward the radius; off: fully up to it"}};
  lumen::Property<float> strength{this, "strength", 1.0f, {.min = 0, .max = 8, .doc = "exponent of the visibility; 1 is as measured"}};
  lumen::Property<bool> half_resolution{this, "half_resolution", false, {.doc = "gather at half the resolution and scale up along surfaces: faster, softer"}};
  lumen::Property<bool> blur{this, "blur", true, {.doc = "average the noise over 4x4 pixels of the same surface", .advanced = true}};
  lumen::Property<int> refinements;

  lumen::Reads depth{this, "depth"}, normal{this, "normal"};
  lumen::Writes occlusion{this, "occlusion", lumen::Format::R32F};

  void render(lumen::Frame& frame) override { gather_and_smooth(frame, {}); }

 protected:
  /// `inputs`: what the shader reads besides its layers.
  void gather_and_smooth(lumen::Frame& frame, lumen::TextureInputs inputs) {
    constexpr const char* smooth = "lib/occlusion_blur.glsl";
    const glm::ivec2 size = half_resolution ? (frame.size() + 1) / 2 : frame.size();
    const auto scratch = [&](const char* name) { return &frame.scratch(name, lumen::Format::RG32F, size); };
    const bool odd = frame.iteration() % 2 != 0;
    const lumen::gl::Texture *sum = scratch(odd ? "odd" : "even"), *before = refinements > 1 ? scratch(odd ? "even" : "odd") : sum;
    const lumen::gl::Texture& refinement = frame.scratch("refinement", lumen::Format::R32F, {1, 1});
    const float number = float(frame.iteration());
    refinement.upload(&number);

    inputs.emplace_back("before", before);
    inputs.emplace_back("refinement", &refinement);
    frame.fullscreen(shader_, {.function = "gather", .target = sum, .inputs = std::move(inputs), .covered_only = true});
    const lumen::gl::Texture* raw = sum;
    const auto pass = [&](const char* function, const lumen::gl::Texture* target) {
      frame.fullscreen(smooth, {.function = function, .target = target, .inputs = {{"raw", raw}, {"refinement", &refinement}}, .covered_only = true});
      raw = target;
    };
    if (blur) pass("rows", scratch("rows"));
    if (blur && half_resolution) pass("columns", scratch("columns"));
    pass(half_resolution ? "upsampled" : blur ? "smooth_columns" : "rest", nullptr);
    if (frame.iteration() + 1 < refinements) frame.unfinished(float(frame.iteration() + 1) / float(refinements));
  }

 private:
  const char* shader_;
};
