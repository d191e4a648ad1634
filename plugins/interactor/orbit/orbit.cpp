/// A camera that turns about a pivot: arcball by quaternions (Shoemake, Graphics Interface 1992) or turntable, pan, zoom to
/// the pointer, roll, fit, standard views, perspective and orthographic.
#include <cmath>

#include <lumen/arcball.h>
#include <lumen/interactor.h>

#include "navigation.h"

namespace {

using namespace lumen;
using orbit::Lens;
using orbit::Pose;

constexpr double jump_seconds = 0.2;
constexpr float key_degrees = 15, key_pan_pixels = 40, zoom_per_notch = 0.9f, zoom_per_pixel = 0.995f;

struct Orbit : Interactor {
  using Interactor::Interactor;

  // The default looks along +y with z up: medical volumes are seen from the front.
  Property<glm::quat> rotation{this, "rotation", glm::quat(0.70710678f, -0.70710678f, 0, 0), {.doc = "turns the world to the eye's axes: x right, y up, z toward the eye"}};
  Property<float> distance{this, "distance", 4.0f, {.min = 1e-6, .max = 1e12, .unit = "world", .doc = "from the eye to the pivot; follows the scene until it is set", .logarithmic = true}};
  Property<glm::vec3> pivot{this, "pivot", glm::vec3(0), {.unit = "world", .doc = "what the camera turns about; the scene's center until it is set"}};
  Property<Choice> projection{this, "projection", Choice{"perspective"}, {.doc = "how depth is seen", .choices = {"perspective", "orthographic"}}};
  Property<float> field_of_view{this, "field_of_view", 30.0f, {.min = 1, .max = 150, .unit = "degrees", .doc = "vertical angle of a perspective view", .when = "projection = perspective"}};
  Property<float> height{this, "height", 2.0f, {.min = 1e-6, .max = 1e12, .unit = "world", .doc = "vertical extent of an orthographic view; follows the scene until it is set", .when = "projection = orthographic", .logarithmic = true}};
  Property<Choice> style{this, "style", Choice{"trackball"}, {.doc = "dragging turns freely, or keeps the world's z upright", .choices = {"trackball", "turntable"}, .affects = Affects::nothing}};

  bool is_camera() const override { return true; }

  Camera camera() const override {
    const Pose now = pose();
    return {.view = orbit::view_matrix(now), .orthographic = lens().orthographic, .field_of_view = field_of_view, .height = now.height, .pivot = now.pivot, .distance = now.distance};
  }

  void scene_changed(const Bounds& scene, float aspect) override {
    if (scene.empty()) return;
    const Pose fit = orbit::fitted(pose(), lens(), scene, aspect);
    pivot.set_default(fit.pivot);
    distance.set_default(fit.distance);
    height.set_default(fit.height);
  }

  bool input(const InputEvent& event, ViewInput& view) override {
    switch (event.type) {
      case InputEvent::Type::press: return press(event, view);
      case InputEvent::Type::move: return move(event, view);
      case InputEvent::Type::release: {
        const bool was_held = drag_ != Drag::none;
        drag_ = Drag::none;
        return was_held;
      }
      case InputEvent::Type::wheel:
        apply(orbit::zoomed(pose(), lens(), std::pow(zoom_per_notch, event.wheel), event.position, view.size()));
        return true;
      case InputEvent::Type::double_click: return double_click(event, view);
      case InputEvent::Type::key: return key(event, view);
      case InputEvent::Type::click: return false;
    }
    return false;
  }

  void tick(ViewInput& view) override {
    if (!jump_) return;
    const double along = (view.time() - jump_->begin) / jump_seconds;
    apply(along >= 1 ? jump_->to : orbit::between(jump_->from, jump_->to, static_cast<float>(std::max(0.0, along))));
    if (along >= 1) jump_.reset();
    else view.animate();
  }

 private:
  enum class Drag { none, turn, pan, zoom, roll };
  struct Jump { Pose from, to; double begin; };

  Pose pose() const { return {rotation, pivot, distance, height}; }
  Lens lens() const { return {projection.get() == "orthographic", field_of_view}; }

  /// Sets what differs and nothing else: what stays a default goes on following the scene.
  void apply(const Pose& next) {
    const Pose now = pose();
    if (next.rotation != now.rotation) rotation.set(next.rotation);
    if (next.pivot != now.pivot) pivot.set(next.pivot);
    if (next.distance != now.distance) distance.set(next.distance);
    if (next.height != now.height) height.set(next.height);
  }

  void jump(const Pose& to, ViewInput& view) {
    if (view.reduced_motion()) {
      jump_.reset();
      apply(to);
      return;
    }
    jump_ = Jump{pose(), to, view.time()};
    view.animate();
  }

  static Drag meaning(const InputEvent& event, bool blender) {
    using Button = InputEvent::Button;
    const bool main = event.button == (blender ? Button::middle : Button::left);
    if (main && event.control && event.shift) return Drag::roll;
    if (main && event.shift) return Drag::pan;
    if (main && event.control) return Drag::zoom;
    if (main) return Drag::turn;
    if (blender) return Drag::none;
    if (event.button == Button::middle) return Drag::pan;
    return event.button == Button::right ? Drag::zoom : Drag::none;
  }

  bool press(const InputEvent& event, ViewInput& view) {
    drag_ = meaning(event, view.blender_keys());
    if (drag_ == Drag::none) return false;
    jump_.reset();
    start_ = pose();
    start_position_ = event.position;
    return true;
  }

  /// Every move starts from the press: going back there undoes it exactly.
  bool move(const InputEvent& event, ViewInput& view) {
    const glm::ivec2 size = view.size();
    const glm::vec2 pixels = event.position - start_position_, center = 0.5f * glm::vec2(size);
    switch (drag_) {
      case Drag::none: return false;
      case Drag::turn:
        if (style.get() == "turntable") {
          apply(orbit::turned(start_, pixels, size));
        } else {
          Pose next = start_;
          next.rotation = glm::normalize(arcball(start_position_, event.position, size) * start_.rotation);
          apply(next);
        }
        return true;
      case Drag::pan: apply(orbit::panned(start_, lens(), pixels, size)); return true;
      case Drag::zoom: apply(orbit::zoomed(start_, lens(), std::pow(zoom_per_pixel, -pixels.y), start_position_, size)); return true;
      case Drag::roll: {
        const glm::vec2 from = start_position_ - center, to = event.position - center;
        apply(orbit::rolled(start_, glm::degrees(std::atan2(from.y, from.x) - std::atan2(to.y, to.x))));
        return true;
      }
    }
    return false;
  }

  bool double_click(const InputEvent& event, ViewInput& view) {
    if (event.button != InputEvent::Button::left) return false;
    if (const auto surface = view.surface_at(event.position)) {
      Pose next = pose();
      next.pivot = *surface;
      jump(next, view);
    } else {
      fit(view.scene(), view);
    }
    return true;
  }

  void fit(const Bounds& bounds, ViewInput& view) {
    const glm::ivec2 size = view.size();
    jump(orbit::fitted(pose(), lens(), bounds, static_cast<float>(size.x) / static_cast<float>(std::max(1, size.y))), view);
  }

  bool key(const InputEvent& event, ViewInput& view) {
    const std::string& key = event.key;
    const Pose from = jump_ ? jump_->to : pose();
    if (const auto standard = orbit::standard_view(key, event.control)) {
      Pose next = from;
      next.rotation = *standard;
      jump(next, view);
    } else if (key == "2" || key == "4" || key == "6" || key == "8") {
      jump(stepped(from, key.front(), event, view.size()), view);
    } else if (key == "5") {
      switch_projection();
    } else if (key == "Plus" || key == "Minus") {
      jump(orbit::zoomed(from, lens(), key == "Plus" ? zoom_per_notch : 1 / zoom_per_notch, 0.5f * glm::vec2(view.size()), view.size()), view);
    } else if (key == "Home" || key == "R") {
      fit(view.scene(), view);
    } else if (key == "Period") {
      fit(view.selection(), view);
    } else if (key == "Comma") {
      if (const auto surface = view.surface_at(event.position)) {
        Pose next = from;
        next.pivot = *surface;
        jump(next, view);
      }
    } else {
      return false;
    }
    return true;
  }

  static Pose stepped(const Pose& from, char digit, const InputEvent& event, glm::ivec2 size) {
    const glm::vec2 toward = digit == '4' ? glm::vec2(-1, 0) : digit == '6' ? glm::vec2(1, 0) : digit == '8' ? glm::vec2(0, -1) : glm::vec2(0, 1);
    if (event.control) return orbit::panned(from, {}, toward * key_pan_pixels, size);
    if (event.shift && toward.x != 0) return orbit::rolled(from, -toward.x * key_degrees);
    Pose next = from;
    // The eye goes the way of the key, about its own axes.
    next.rotation = glm::normalize(glm::angleAxis(glm::radians(-toward.x * key_degrees), glm::vec3(0, 1, 0)) *
                                   glm::angleAxis(glm::radians(-toward.y * key_degrees), glm::vec3(1, 0, 0)) * from.rotation);
    return next;
  }

  /// What is at the pivot keeps its size.
  void switch_projection() {
    const float tangent = std::tan(glm::radians(field_of_view.get()) / 2);
    if (lens().orthographic) {
      distance.set(height / (2 * tangent));
      projection.set(Choice{"perspective"});
    } else {
      height.set(2 * distance * tangent);
      projection.set(Choice{"orthographic"});
    }
  }

  Drag drag_ = Drag::none;
  Pose start_;
  glm::vec2 start_position_{0};
  std::optional<Jump> jump_;
};

}  // namespace

LUMEN_PLUGIN(Orbit, "interactor.orbit", "a camera that turns about a pivot: trackball (Shoemake 1992) or turntable, pan, zoom to the pointer, fit, standard views")
