/// Ambient occlusion from a hemisphere of samples around the normal, compared with the stored depth.
/// Mittring, Finding Next Gen: CryEngine 2, SIGGRAPH 2007 courses; the hemisphere after Ostendorf 2021, section 3.7.

#include <lumen/occlusion.h>

namespace {

struct Ssao : lumen::Occlusion {
  using Occlusion::Occlusion;

  lumen::Property<float> radius{this, "radius", 0.05f, {.min = 0.001, .max = 1, .unit = "scene radii", .doc = "how far an occluder reaches", .logarithmic = true}};
  lumen::Property<float> bias{this, "bias", 0.05f, {.min = 0, .max = 2, .unit = "radii", .doc = "how much nearer than a sample the surface must be to occlude it; hides steps of the depth"}};
  lumen::Property<float> strength{this, "strength", 1.0f, {.min = 0, .max = 8, .doc = "exponent of the visibility; 1 is as measured"}};
  lumen::Property<int> samples{this, "samples", 32, {.min = 1, .max = 256, .doc = "taps per pixel", .constant = true}};
  lumen::Property<bool> blur{this, "blur", true, {.doc = "average the 16 rotations of the kernel over 4x4 pixels of the same surface", .advanced = true}};

  lumen::Reads depth{this, "depth"}, normal{this, "normal"};
  lumen::Writes occlusion{this, "occlusion", lumen::Format::R32F};

  void render(lumen::Frame& frame) override {
    constexpr const char* shader = "occlusion/ssao.glsl";
    if (!blur) return frame.fullscreen(shader, {.function = "occlusion", .covered_only = true});
    const auto& raw = frame.scratch("raw", lumen::Format::R32F, frame.size());
    frame.fullscreen(shader, {.function = "occlusion", .target = &raw, .covered_only = true});
    frame.fullscreen(shader, {.function = "smoothed", .inputs = {{"raw", &raw}}, .covered_only = true});
  }
};

}  // namespace

LUMEN_PLUGIN(Ssao, "occlusion.ssao", "Ambient occlusion from a hemisphere of samples. Mittring, Finding Next Gen: CryEngine 2, SIGGRAPH 2007 courses.")
