/// A cube in a corner of the picture that turns as the scene does, with the lights around it; a click on a face, an edge or a
/// corner looks from there, a drag turns the camera. Khan, Mordatch, Fitzmaurice, Matejka, Kurtenbach, ViewCube, I3D 2008.

#include <algorithm>
#include <array>
#include <string>

#include <lumen/arcball.h>
#include <lumen/interactor.h>

#include "cube.h"

namespace {

using namespace lumen;

constexpr double turn_seconds = 0.2;
constexpr int most_lights = 16;

struct ViewCube : Interactor {
  /// Until somebody says otherwise it turns the camera of the view that all sessions begin with.
  explicit ViewCube(Binding& binding) : Interactor(binding) { camera_turned.link("main.camera"); }

  Property<Reference> camera_turned{this, "camera", {}, {.doc = "what it turns; follows the camera of view main until it is set", .accepts = "camera", .affects = Affects::nothing}};
  Property<glm::quat> rotation{this, "rotation", glm::quat(1, 0, 0, 0), {.doc = "the camera's, by a link that the cube makes", .advanced = true, .affects = Affects::nothing}};
  Property<Choice> corner{this, "corner", Choice{"top_right"}, {.doc = "of the picture", .choices = {"top_left", "top_right", "bottom_left", "bottom_right"}}};
  Property<float> size{this, "size", 0.14f, {.min = 0.02, .max = 1, .unit = "shorter sides", .doc = "of the square that holds the cube and the lights"}};
  Property<float> opacity{this, "opacity", 0.9f, {.min = 0, .max = 1, .doc = "of the cube; 0 leaves the picture as it is"}};
  Property<bool> lights{this, "lights", true, {.doc = "spheres in the lights' colors, where they shine from"}};
  Property<int> hovered{this, "hovered", view_cube::nowhere, {.min = 0, .max = 26, .doc = "the place under the pointer, of 3 x 3 x 3; 13 is none", .advanced = true}};

  Reads color_in{this, "color"};
  Writes color_out{this, "color", Format::RGBA16F};

  void changed(std::string_view property) override {
    // Setting a linked rotation turns the camera.
    if (property != "camera") return;
    if (camera_turned->empty()) rotation.unlink();
    else rotation.link(camera_turned->id + ".rotation");
  }

  bool input(const InputEvent& event, ViewInput& view) override {
    switch (event.type) {
      case InputEvent::Type::press: return press(event, view);
      case InputEvent::Type::move:
        if (held_) drag(event, view);
        else hovered.set_default(view_cube::index_of(under(event.position, view).value_or(view_cube::Place(0))));
        return held_ || *hovered != view_cube::nowhere;
      case InputEvent::Type::release:
        if (held_ && !dragged_) look_from(*held_, view);
        return std::exchange(held_, std::nullopt).has_value();
      // The second of two clicks is not the scene's.
      case InputEvent::Type::double_click: return under(event.position, view).has_value();
      case InputEvent::Type::wheel: case InputEvent::Type::key: case InputEvent::Type::click: return false;
    }
    return false;
  }

  void tick(ViewInput& view) override {
    if (!turn_) return;
    const float along = float(std::clamp((view.time() - turn_->begin) / turn_seconds, 0.0, 1.0));
    const Turn turn = *turn_;
    if (along >= 1) turn_.reset();
    else view.animate();
    rotation.set(glm::slerp(turn.from, turn.to, along * along * (3 - 2 * along)));
  }

  void draw(Frame& frame) override {
    const auto& markers = frame.scratch("markers", Format::RGBA32F, {most_lights, 2});
    markers.upload(&marker_texels(frame)[0].x);
    frame.fullscreen("interactor/view_cube.glsl", {.inputs = {{"markers", &markers}}});
  }

 private:
  struct Turn { glm::quat from, to; double begin; };

  /// Directions toward the lights as the eye sees them, w = 1 where there is one; then their colors.
  std::array<glm::vec4, 2 * most_lights> marker_texels(const Frame& frame) const {
    std::array<glm::vec4, 2 * most_lights> texels{};
    int index = 0;
    for (const Light& light : frame.lights()) {
      if (!lights || index == most_lights) break;
      const glm::vec3 arm = light.point ? light.position - frame.camera().pivot : light.direction;
      if (glm::dot(arm, arm) == 0) continue;
      texels[std::size_t(index)] = glm::vec4(glm::mat3(frame.camera().view) * glm::normalize(arm), 1);
      texels[std::size_t(most_lights + index++)] = glm::vec4(light.color, 1);
    }
    return texels;
  }

  /// In the cube's square, -1..1 each way with y up.
  glm::vec2 in_square(glm::vec2 pixel, const ViewInput& view) const {
    const glm::vec2 whole(view.size());
    const float side = size * std::min(whole.x, whole.y);
    const bool right = corner.get() == "top_right" || corner.get() == "bottom_right", bottom = corner.get() == "bottom_left" || corner.get() == "bottom_right";
    const glm::vec2 center(right ? whole.x - 0.5f * side : 0.5f * side, bottom ? whole.y - 0.5f * side : 0.5f * side);
    return glm::vec2(pixel.x - center.x, center.y - pixel.y) / (0.5f * side);
  }

  std::optional<view_cube::Place> under(glm::vec2 pixel, const ViewInput& view) const {
    return view_cube::place_at(in_square(pixel, view), glm::quat_cast(glm::mat3(view.camera().view)));
  }

  bool press(const InputEvent& event, ViewInput& view) {
    if (event.button != InputEvent::Button::left || !event.held.empty()) return false;
    held_ = under(event.position, view);
    dragged_ = false;
    start_ = *rotation;
    start_position_ = event.position;
    if (held_) turn_.reset();
    return held_.has_value();
  }

  void drag(const InputEvent& event, ViewInput& view) {
    dragged_ = dragged_ || event.position != start_position_;
    if (!dragged_) return;
    // The square is the ball.
    constexpr float ball = 1000;
    const auto on_ball = [&](glm::vec2 pixel) { return 0.5f * ball * (glm::vec2(1, -1) * in_square(pixel, view) + 1.0f); };
    rotation.set(glm::normalize(arcball(on_ball(start_position_), on_ball(event.position), glm::ivec2(int(ball))) * start_));
  }

  void look_from(const view_cube::Place& place, ViewInput& view) {
    const glm::quat to = view_cube::rotation_toward(place);
    if (view.reduced_motion()) return rotation.set(to);
    turn_ = Turn{*rotation, to, view.time()};
    view.animate();
  }

  std::optional<view_cube::Place> held_;
  bool dragged_ = false;
  glm::quat start_{1, 0, 0, 0};
  glm::vec2 start_position_{0};
  std::optional<Turn> turn_;
};

}  // namespace

LUMEN_PLUGIN(ViewCube, "interactor.view_cube", "A cube that shows and turns the view, with the lights around it. Khan et al., ViewCube, I3D 2008.")
