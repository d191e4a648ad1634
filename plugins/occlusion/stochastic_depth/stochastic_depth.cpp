/// Ambient occlusion from a hemisphere of samples, each compared with several surfaces of its pixel: what the front surface hides
/// occludes, too. Which surfaces they are, chance decides.
/// Vermeer, Scandolo, Eisemann, Stochastic-Depth Ambient Occlusion, Proc. ACM Comput. Graph. Interact. Tech. 4(1) (I3D), 2021.

#include <array>
#include <cmath>
#include <string>

#include <glm/trigonometric.hpp>

#include "../hemisphere.h"

namespace {

constexpr std::array names{"first", "second", "third", "fourth"};  // the channels of a texel hold so many

/// The camera whose picture is the layers with their border.
lumen::Camera camera_of_layers(const lumen::Frame& frame) {
  const float wider = float(frame.size().y) / float(frame.size().y - 2 * frame.border());
  lumen::Camera camera = frame.camera();
  camera.height *= wider;
  camera.field_of_view = 2 * glm::degrees(std::atan(wider * std::tan(glm::radians(0.5f * camera.field_of_view))));
  return camera;
}

struct StochasticDepth : HemisphereOcclusion {
  explicit StochasticDepth(lumen::Binding& binding)
      : HemisphereOcclusion(binding, "occlusion/stochastic_depth.glsl", {.common = {.radius = 0.2f, .refinements = 8}, .samples = 16}) {}

  lumen::Property<float> thickness{this, "thickness", 0.5f, {.min = 0.01, .max = 4, .unit = "radii", .doc = "how far a surface reaches back; what lies farther behind it is open, unless another surface hides it"}};
  lumen::Property<int> depths{this, "depths", 4, {.min = 1, .max = int(names.size()), .doc = "surfaces per pixel beside the front one; each is one drawing of the opaque scene"}};
  lumen::Property<float> share{this, "share", 0.4f, {.min = 0.05, .max = 1, .doc = "the chance of a surface to be in a drawing: small ones reach far back, large ones seldom come back empty; 1 is the front one alone", .advanced = true}};

  void render(lumen::Frame& frame) override {
    // A refinement replaces one drawing, so that the mean sees many for the price of one.
    const int first = frame.iteration() == 0 ? 0 : depths + frame.iteration() - 1;
    const lumen::Camera camera = camera_of_layers(frame);
    for (int sample = first; sample < depths + frame.iteration(); ++sample) frame.draw_depth(camera, drawing(frame, sample), {.share = share, .sample = sample});

    lumen::TextureInputs drawings;
    for (int i = 0; i < int(names.size()); ++i) drawings.emplace_back(names[std::size_t(i)], &drawing(frame, i));
    const lumen::gl::Texture& behind = frame.scratch("behind", lumen::Format::RGBA32F, frame.size());
    frame.fullscreen("occlusion/stochastic_depth.glsl", {.function = "side_by_side", .target = &behind, .inputs = std::move(drawings)});
    gather_and_smooth(frame, {{"behind", &behind}});
  }

 private:
  const lumen::gl::Texture& drawing(lumen::Frame& frame, int sample) const {
    return frame.scratch(names[std::size_t(sample % depths)], lumen::Format::R32F, frame.size());
  }
};

}  // namespace

LUMEN_PLUGIN(StochasticDepth, "occlusion.stochastic_depth", "Ambient occlusion that also sees what the front surface hides. Vermeer, Scandolo, Eisemann, Stochastic-Depth Ambient Occlusion, I3D 2021.")
