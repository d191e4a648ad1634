/// Ambient occlusion in a grid of voxels that the depth layer fills: the picture's columns by 96 slices of the scene's depth, a bit each.
/// Penmatsa, Nichols, Wyman, Voxel-Space Ambient Occlusion, I3D 2010 posters.

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/trigonometric.hpp>

#include "../screen_space.h"

namespace {

constexpr float slices = 96;  // as many bits as four channels hold exactly, see voxel.glsl

struct Voxel : ScreenSpace {
  explicit Voxel(lumen::Binding& binding) : ScreenSpace(binding, "occlusion/voxel.glsl", {.radius = 0.25f, .refinements = 16}) {}

  lumen::Property<float> thickness{this, "thickness", 0.08f, {.min = 0.001, .max = 4, .unit = "scene radii", .doc = "how far a surface fills voxels behind what is seen of it", .logarithmic = true}};
  lumen::Property<int> rays{this, "rays", 8, {.min = 1, .max = 64, .doc = "sent from a pixel per refinement", .constant = true}};
  lumen::Property<int> steps{this, "steps", 12, {.min = 1, .max = 128, .doc = "voxels that a ray looks into", .constant = true}};

  void render(lumen::Frame& frame) override {
    const lumen::gl::Texture& voxels = frame.scratch("voxels", lumen::Format::RGBA32F, columns(frame));
    if (frame.iteration() == 0) frame.fullscreen("occlusion/voxel.glsl", {.function = "fill", .target = &voxels});
    gather_and_smooth(frame, {{"voxels", &voxels}});
  }

 private:
  /// As many as make cubes of the voxels in the middle of the scene; none narrower than a pixel or wider than 8.
  static glm::ivec2 columns(const lumen::Frame& frame) {
    const lumen::Camera& camera = frame.camera();
    const float middle = std::max(0.5f * (frame.extent().x + frame.extent().y), 1e-6f * frame.scene_radius());
    const float visible = camera.orthographic ? camera.height : 2 * middle * std::tan(glm::radians(0.5f * camera.field_of_view));
    const float pixels = 2 * frame.scene_radius() / slices * float(frame.size().y - 2 * frame.border()) / visible;
    return glm::ivec2(glm::ceil(glm::vec2(frame.size()) / std::clamp(pixels, 1.0f, 8.0f)));
  }
};

}  // namespace

LUMEN_PLUGIN(Voxel, "occlusion.voxel", "Ambient occlusion from voxels of the visible surfaces. Penmatsa, Nichols, Wyman, Voxel-Space Ambient Occlusion, I3D 2010 posters.")
