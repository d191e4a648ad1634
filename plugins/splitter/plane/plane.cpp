/// Two halves of a surface, cut by a plane and moved apart along its normal; one sees into the hollow halves.
/// Schwankl, Splitting of Meshes in Image-Space, Vienna 2013.

#include <glm/gtc/matrix_transform.hpp>
#include <lumen/splitter.h>

namespace {

struct Plane : lumen::Splitter {
  using Splitter::Splitter;

  lumen::Property<glm::vec3> translation{this, "translation", glm::vec3(0), {.unit = "world", .doc = "a point of the plane"}};
  lumen::Property<glm::vec3> axis{this, "axis", glm::vec3(0, 1, 0), {.min = -1, .max = 1, .doc = "what the normal, +z, is turned about"}};
  lumen::Property<float> angle{this, "angle", 0.0f, {.min = -180, .max = 180, .unit = "degrees", .doc = "how far the normal is turned"}};
  lumen::Property<float> offset{this, "offset", 0.0f, {.min = 0, .unit = "world", .doc = "how far each half moves along the normal"}};

  std::vector<lumen::Part> parts(const lumen::Bounds&) const override {
    const glm::vec3 about = axis;
    const glm::mat4 turn = glm::length(about) > 0 ? glm::rotate(glm::mat4(1), glm::radians(angle.get()), glm::normalize(about)) : glm::mat4(1);
    const glm::vec3 normal(turn[2]);
    const glm::vec4 plane(normal, -glm::dot(normal, translation.get()));
    const glm::vec3 move = offset.get() * normal;
    return {{glm::translate(glm::mat4(1), move), {plane}}, {glm::translate(glm::mat4(1), -move), {-plane}}};
  }
};

}  // namespace

LUMEN_PLUGIN(Plane, "splitter.plane", "Two halves of a surface, cut by a plane and moved apart. Schwankl, Splitting of Meshes in Image-Space, Vienna 2013.")
