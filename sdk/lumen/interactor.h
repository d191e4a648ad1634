/// Interactors: input becomes properties. They may draw over the picture; they may be a camera or a light.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <lumen/camera.h>
#include <lumen/frame.h>
#include <lumen/plugin.h>

namespace lumen {

/// One event in a view. Positions in pixels of the view, origin top left.
struct InputEvent {
  /// click: pressed and released in place; it follows the release, unless somebody else than the camera claimed the press.
  enum class Type { press, release, move, wheel, double_click, key, click };
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

/// The surface of triangles under a pixel.
struct Picked {
  std::string renderer;              ///< id
  int part = 0;                      ///< of its split
  glm::mat4 moved{1};                ///< world to world: where the split moved the part
  int cell = -1;                     ///< of the source data; -1: a cap
  glm::vec3 position{0};             ///< world, where it is drawn
  std::shared_ptr<const Mesh> mesh = {};
  glm::mat4 object_to_world{1};
};

/// What the pointer looks like.
enum class Cursor { arrow, hand, move };

/// Words beside a place of the scene.
struct Label {
  glm::vec3 position{0};             ///< world
  std::string text;                  ///< lines
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
  /// The nearest surface under a pixel of these renderers; none named: of all that are made of triangles, so that one sees
  /// through a cutting plane's rectangle. Nothing on the background.
  virtual std::optional<Picked> pick(glm::vec2 pixel, const std::vector<std::string>& renderers = {}) { (void)pixel, (void)renderers; return {}; }
  /// Of the pointer, until the next event.
  virtual void set_cursor(Cursor cursor) { (void)cursor; }
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

  /// True claims the event; a claimed press receives all events up to its release. The camera is asked last. Key "Esc" asks
  /// whoever has the press to give it up: claimed, all that was written since the press is taken back, and no release follows.
  virtual bool input(const InputEvent& event, ViewInput& view) { (void)event; (void)view; return false; }
  /// Shown by the window over the picture, not part of pictures that are written.
  virtual std::vector<Label> labels() const { return {}; }
  /// Once per frame while animate() was asked for.
  virtual void tick(ViewInput& view) { (void)view; }
  /// Draws over the finished picture: reads it as layer `color` and writes it anew as `color`. Called while the plugin declares
  /// Writes; those of a moment (a std::optional) cost nothing else.
  virtual void draw(Frame& frame) { (void)frame; }
};

}  // namespace lumen
