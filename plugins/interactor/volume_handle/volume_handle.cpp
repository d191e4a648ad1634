/// A cut volume drawn over the picture, with handles: dragging one resizes the volume, dragging its middle moves it. Knoedel,
/// Hachet, Guitton, Interactive Generation and Modification of Cutaway Illustrations for Polygonal Models, Smart Graphics 2009.

#include <array>
#include <cmath>
#include <optional>

#include <lumen/interactor.h>

#include "cut_volume.h"
#include "ink.h"

namespace {

using namespace lumen;
using cut_volume::Handle;

constexpr float grip_radius = 5, grip_reach = 10, line_width = 1.5f;  // pixels

/// A picture of the scene, its pixels from the bottom left.
struct Projection {
  const Camera& camera;
  glm::vec2 size;

  /// View-space lengths at distance 1 (orthographic: anywhere) of a pixel.
  float pixel() const { return (camera.orthographic ? camera.height : 2 * std::tan(glm::radians(camera.field_of_view) / 2)) / size.y; }
  /// Nothing behind the eye.
  std::optional<glm::vec2> place(glm::vec3 world) const {
    const glm::vec3 seen = camera.view * glm::vec4(world, 1);
    if (!camera.orthographic && seen.z >= -1e-6f * camera.distance) return std::nullopt;
    return 0.5f * size + glm::vec2(seen) / (pixel() * (camera.orthographic ? 1.0f : -seen.z));
  }
  cut_volume::Ray ray(glm::vec2 place) const {
    const glm::vec2 plane = (place - 0.5f * size) * pixel();
    const glm::mat4 to_world = glm::inverse(camera.view);
    if (camera.orthographic) return {to_world * glm::vec4(plane, 0, 1), -glm::vec3(to_world[2])};
    return {to_world[3], glm::normalize(glm::mat3(to_world) * glm::vec3(plane, -1))};
  }
};

struct VolumeHandle : Interactor {
  explicit VolumeHandle(Binding& binding) : Interactor(binding) { changed(volume.id()); }

  Property<Reference> volume{this, "volume", {}, {.doc = "the splitter.volume that it holds", .accepts = "splitter", .affects = Affects::nothing}};
  Property<Choice> shape{this, "shape", Choice{"sphere"}, {.doc = linked, .choices = {"sphere", "box", "wedge", "tube"}, .advanced = true}};
  Property<glm::vec3> center{this, "center", glm::vec3(0), {.unit = "world", .doc = linked, .advanced = true}};
  Property<glm::quat> rotation{this, "rotation", glm::quat(1, 0, 0, 0), {.doc = linked, .advanced = true}};
  Property<float> radius{this, "radius", 0.0f, {.min = 0, .unit = "world", .doc = linked, .advanced = true}};
  Property<glm::vec3> size{this, "size", glm::vec3(0), {.min = 0, .unit = "world", .doc = linked, .advanced = true}};
  Property<float> length{this, "length", 0.0f, {.min = 0, .unit = "world", .doc = linked, .advanced = true}};
  Property<float> angle{this, "angle", 90.0f, {.min = 0, .max = 180, .unit = "degrees", .doc = linked, .advanced = true}};

  Reads color_in{this, "color"};
  Writes color_out{this, "color", Format::RGBA16F};

  void changed(std::string_view property) override {
    if (property != volume.id()) return;
    for (PropertyBase* own : std::array<PropertyBase*, 7>{&shape, &center, &rotation, &radius, &size, &length, &angle}) {
      if (volume->empty()) own->unlink();
      else own->link(volume->id + "." + std::string(own->id()));
    }
  }

  bool input(const InputEvent& event, ViewInput& view) override {
    const Projection seen{view.camera(), glm::vec2(view.size())};
    const glm::vec2 pointer(event.position.x, seen.size.y - event.position.y);
    switch (event.type) {
      case InputEvent::Type::press:
        if (volume->empty() || event.button != InputEvent::Button::left || !event.held.empty()) return false;
        held_ = under(pointer, seen);
        start_ = now();
        start_pointer_ = pointer;
        return held_.has_value();
      case InputEvent::Type::move:
        if (held_) set(cut_volume::dragged(start_, *held_, seen.ray(start_pointer_), seen.ray(pointer), seen.camera));
        return held_.has_value();
      case InputEvent::Type::release: return std::exchange(held_, std::nullopt).has_value();
      case InputEvent::Type::wheel: case InputEvent::Type::click: case InputEvent::Type::double_click: case InputEvent::Type::key: return false;
    }
    return false;
  }

  void draw(Frame& frame) override {
    const glm::vec2 border(frame.border());
    const Projection seen{frame.camera(), glm::vec2(frame.size()) - 2.0f * border};
    Ink ink(frame.size());
    if (!volume->empty()) {
      for (const auto& line : cut_volume::outlines_of(now(), frame.camera()))
        for (std::size_t i = 1; i < line.size(); ++i) {
          const auto a = seen.place(line[i - 1]), b = seen.place(line[i]);
          if (a && b) ink.stroke(*a + border, *b + border, line_width);
        }
      for (const Handle& handle : cut_volume::handles_of(now(), frame.camera()))
        if (const auto at = seen.place(handle.place)) ink.dot(*at + border, grip_radius);
    }
    const gl::Texture& texture = frame.scratch("ink", Format::RG8, frame.size());
    ink.upload(texture);
    frame.fullscreen("interactor/volume_handle.glsl", {.inputs = {{"ink", &texture}}});
  }

 private:
  static constexpr const char* linked = "the volume's, by a link that the handle makes";

  cut_volume::Shape now() const { return {.kind = shape->name, .center = center, .rotation = rotation, .radius = radius, .size = size, .length = length, .angle = angle}; }

  /// What did not move is not set.
  void set(const cut_volume::Shape& next) {
    const cut_volume::Shape before = now();
    if (next.center != before.center) center.set(next.center);
    if (next.radius != before.radius) radius.set(next.radius);
    if (next.size != before.size) size.set(next.size);
    if (next.length != before.length) length.set(next.length);
    if (next.angle != before.angle) angle.set(next.angle);
  }

  /// The nearest handle in reach of the pointer.
  std::optional<Handle> under(glm::vec2 pointer, const Projection& seen) const {
    std::optional<Handle> nearest;
    float least = grip_reach;
    for (const Handle& handle : cut_volume::handles_of(now(), seen.camera)) {
      const auto at = seen.place(handle.place);
      if (!at || glm::distance(*at, pointer) > least) continue;
      least = glm::distance(*at, pointer);
      nearest = handle;
    }
    return nearest;
  }

  std::optional<Handle> held_;
  cut_volume::Shape start_;
  glm::vec2 start_pointer_{0};
};

}  // namespace

LUMEN_PLUGIN(VolumeHandle, "interactor.volume_handle", "A cut volume over the picture with handles that move and resize it. Knoedel, Hachet, Guitton, Interactive Generation and Modification of Cutaway Illustrations for Polygonal Models, Smart Graphics 2009.")
