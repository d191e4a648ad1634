/// A light: directional or a point, turned by dragging with L held (quaternions, as the arcball turns); a sphere shows it then.
#include <algorithm>
#include <cmath>
#include <optional>

#include <lumen/arcball.h>
#include <lumen/interactor.h>

namespace {

using namespace lumen;

constexpr float key_degrees = 15;
constexpr double shown_after_key = 0.7;  // seconds

/// What the sphere is drawn with: only while it is declared does the light take part in the picture.
struct SphereLayers {
  explicit SphereLayers(Plugin* owner) : read(owner, "color"), written(owner, "color", Format::RGBA16F) {}
  Reads read;
  Writes written;
};

struct LightSource : Interactor {
  explicit LightSource(Binding& binding) : Interactor(binding) { changed(sphere.id()); }

  Property<Choice> type_of_light{this, "kind", Choice{"directional"}, {.doc = "parallel light from far away, or light from a point", .choices = {"directional", "point"}}};
  // Over the left shoulder of the camera's default view, which looks along +y with z up.
  Property<glm::vec3> direction{this, "direction", glm::vec3(-0.35f, -1.0f, 0.55f), {.min = -1e6, .max = 1e6, .doc = "toward the light, world; any length", .when = "kind = directional"}};
  Property<glm::vec3> position{this, "position", glm::vec3(0, -10, 10), {.unit = "world", .doc = "where the light is", .when = "kind = point"}};
  Property<Color> color{this, "color", Color(1, 1, 1), {.min = 0, .max = 1, .doc = "linear color"}};
  Property<float> intensity{this, "intensity", 1.0f, {.min = 0, .max = 100, .doc = "times the color"}};
  Property<Choice> falloff{this, "falloff", Choice{"none"}, {.doc = "what the light is divided by: nothing, the distance, its square", .when = "kind = point", .choices = {"none", "linear", "quadratic"}}};
  Property<bool> attached{this, "attached", false, {.doc = "direction and position are the eye's, not the world's: the light goes along with the camera"}};
  Property<bool> sphere{this, "sphere", false, {.doc = "a sphere over the picture shows where the light shines from; by itself while L turns it", .advanced = true}};

  bool is_light() const override { return true; }

  Light light(const Camera& camera) const override {
    const glm::mat3 to_world = attached ? glm::transpose(glm::mat3(camera.view)) : glm::mat3(1);
    const glm::vec3 toward = glm::dot(*direction, *direction) > 0 ? glm::normalize(*direction) : glm::vec3(0, 0, 1);
    Light light;
    light.point = is_point();
    light.direction = to_world * toward;
    light.position = attached ? glm::vec3(glm::inverse(camera.view) * glm::vec4(*position, 1)) : *position;
    light.color = color->rgb * intensity.get();
    light.falloff = falloff.get() == "quadratic" ? Light::Falloff::quadratic : falloff.get() == "linear" ? Light::Falloff::linear : Light::Falloff::none;
    return light;
  }

  bool input(const InputEvent& event, ViewInput& view) override {
    switch (event.type) {
      case InputEvent::Type::press:
        held_ = event.held == "L" && event.button == InputEvent::Button::left;
        start_ = is_point() ? *position : *direction;
        start_position_ = event.position;
        if (held_) sphere.set_default(true);
        return held_;
      case InputEvent::Type::move:
        if (held_) turn(arcball(start_position_, event.position, view.size()), view.camera());
        return held_;
      case InputEvent::Type::release:
        if (held_) sphere.set_default(false);
        return std::exchange(held_, false);
      case InputEvent::Type::key: return event.held == "L" && key(event, view);
      case InputEvent::Type::wheel: case InputEvent::Type::double_click: case InputEvent::Type::click: return false;
    }
    return false;
  }

  /// Takes the sphere away a while after a key turned the light.
  void tick(ViewInput& view) override {
    if (held_ || !*sphere) return;
    if (view.time() < hidden_at_) view.animate();
    else sphere.set_default(false);
  }

  void changed(std::string_view property) override {
    if (property != sphere.id()) return;
    if (*sphere) layers_.emplace(this);
    else layers_.reset();
  }

  void draw(Frame& frame) override {
    const glm::vec4 toward(toward_in_eye_space(frame.camera()), 0);
    const gl::Texture& texture = frame.scratch("toward", Format::RGBA32F, {1, 1});
    texture.upload(&toward.x);
    frame.fullscreen("interactor/light.glsl", {.inputs = {{"toward", &texture}}});
  }

 private:
  bool is_point() const { return type_of_light.get() == "point"; }

  /// Unit; of a point, from what it turns about.
  glm::vec3 toward_in_eye_space(const Camera& camera) const {
    const Light now = light(camera);
    const glm::vec3 toward = glm::mat3(camera.view) * (now.point ? now.position - camera.pivot : now.direction);
    return glm::dot(toward, toward) > 0 ? glm::normalize(toward) : glm::vec3(0, 0, 1);
  }

  /// Turns what was there at the press by an eye-space rotation: a direction about the origin, a point about the pivot.
  void turn(const glm::quat& rotation, const Camera& camera) {
    const glm::mat3 to_eye = attached ? glm::mat3(1) : glm::mat3(camera.view);
    const glm::vec3 center = attached ? glm::vec3(0, 0, -camera.distance) : camera.pivot;
    const auto turned = [&](glm::vec3 arm) { return glm::transpose(to_eye) * (rotation * (to_eye * arm)); };
    if (is_point()) position.set(center + turned(start_ - center));
    else direction.set(turned(start_));
  }

  bool key(const InputEvent& event, ViewInput& view) {
    const char digit = event.key.size() == 1 ? event.key.front() : ' ';
    const glm::vec3 axis = digit == '4' ? glm::vec3(0, -1, 0) : digit == '6' ? glm::vec3(0, 1, 0)
                         : digit == '8' ? glm::vec3(-1, 0, 0) : digit == '2' ? glm::vec3(1, 0, 0) : glm::vec3(0);
    if (axis == glm::vec3(0)) return false;
    start_ = is_point() ? *position : *direction;
    turn(glm::angleAxis(glm::radians(key_degrees), axis), view.camera());
    sphere.set_default(true);
    hidden_at_ = view.time() + shown_after_key;
    view.animate();
    return true;
  }

  std::optional<SphereLayers> layers_;
  bool held_ = false;
  double hidden_at_ = 0;
  glm::vec3 start_{0};
  glm::vec2 start_position_{0};
};

}  // namespace

LUMEN_PLUGIN(LightSource, "interactor.light", "a directional or point light, turned by dragging with L held")
