#include "frame/light_block.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <lumen/interactor.h>

namespace lumenshop {

LightBlock make_lights(const ViewScene& scene, const lumen::Camera& camera) {
  LightBlock block;
  for (Instance* instance : scene.lights) {
    const lumen::Light light = instance->as<lumen::Interactor>(lumen::Kind::interactor)->light(camera);
    auto& out = block.lights[block.count.x++];
    out.place = light.point ? glm::vec4(glm::vec3(camera.view * glm::vec4(light.position, 1)), 1)
                            : glm::vec4(glm::mat3(camera.view) * light.direction / std::max(glm::length(light.direction), 1e-20f), 0);
    // A direction has no distance to fall off by.
    out.color = glm::vec4(light.color, light.point ? float(light.falloff) : 0.0f);
  }
  return block;
}

LightKinds kinds_of(const LightBlock& lights) {
  LightKinds kinds{.count = lights.count.x};
  for (int i = 0; i < kinds.count; ++i) kinds.points += lights.lights[i].place.w > 0.5f;
  return kinds;
}

}  // namespace lumenshop
