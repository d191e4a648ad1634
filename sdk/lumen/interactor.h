/// Interactors: input becomes properties. They may draw over the picture; they may be a camera or a light.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <lumen/camera.h>
#include <lumen/frame.h>
#include <lumen/plugin.h>

namespace lumen {

/// One event in a view. Positions in pixels of the view, origin top left.
struct InputEvent {
  enum class Type { press, release, move, wheel, double_click, key };
  enum class Button { none, left, middle, right };
  Type type = Type::move;
  Button button = Button::none;     ///< pressed, released, or held while moving
  glm::vec2 position{0};
  glm::vec2 delta{0};               ///< since the last move
  float wheel = 0;                  ///< notches, away from the person positive
  bool shift = false, control = false;
  std::string key = {};             ///< "A", "1", "F1", "Left", "Period" ...; numpad digits as digits
  std::string held = {};            ///< a letter key that is held down ("L"), or empty
};

struct Mesh;

/// The surface under a pixel.
struct Picked {
  std::string renderer;              ///< id
  int part = 0;                      ///< of its split
  int cell = -1;                     ///< of the source data; -1: a cap
  glm::vec3 position{0};             ///< world, where it is drawn
  std::shared_ptr<const Mesh> mesh = {};  ///< null: not made of triangles
  glm::mat4 object_to_world{1};
};

/// The view that an event is in.
class ViewInput {
 public:
  virtual ~ViewInput() = default;
  virtual glm::ivec2 size() const = 0;          ///< pixels
  virtual const Camera& camera() const = 0;
  virtual Bounds scene() const = 0;             ///< world
  virtual Bounds selection() const = 0;         ///< world; the scene's if nothing is selected
  /// The surface under a pixel: world position, or nothing on the background.
  virtual std::optional<glm::vec3> surface_at(glm::vec2 pixel) = 0;
  virtual std::string instance_at(glm::vec2 pixel) = 0;  ///< id, or empty
  virtual std::optional<Picked> pick(glm::vec2 pixel) { (void)pixel; return {}; }  ///< nothing on the background
  virtual bool blender_keys() const = 0;        ///< the person chose the Blender preset
  virtual double time() const = 0;              ///< seconds, steady
  virtual bool reduced_motion() const { return false; }  ///< jumps do not ease
  /// Asks for another call of tick() in the next frame.
  virtual void animate() = 0;
};

class Interactor : public Plugin {
 public:
  using Plugin::Plugin;
  Kind kind() const override { return Kind::interactor; }

  virtual bool is_camera() const { return false; }
  virtual bool is_light() const { return false; }
  virtual Camera camera() const { return {}; }
  /// Lights that move with the eye see the camera.
  virtual Light light(const Camera& camera) const { (void)camera; return {}; }

  /// The scene's world bounds changed: fit defaults (Property::set_default) to it. Also called with aspect = width / height of the view.
  virtual void scene_changed(const Bounds& scene, float aspect) { (void)scene; (void)aspect; }

  /// True claims the event; a claimed press receives all events up to its release. The camera is asked last.
  virtual bool input(const InputEvent& event, ViewInput& view) { (void)event; (void)view; return false; }
  /// Once per frame while animate() was asked for.
  virtual void tick(ViewInput& view) { (void)view; }
  /// Draws over the finished picture: reads it as layer `color` and writes it anew as `color`. Called while the plugin declares
  /// Writes; those of a moment (a std::optional) cost nothing else.
  virtual void draw(Frame& frame) { (void)frame; }
};

}  // namespace lumen
