/// A click on a surface tells what is there, and selects its part: link what shall act on the selection, such as the
/// `whole` of a splitter.plane, to it.

#include <algorithm>

#include <lumen/interactor.h>

#include "place.h"

namespace {

using namespace lumen;

constexpr std::size_t most_lines = 12;  // of the label

struct Pick : Interactor {
  using Interactor::Interactor;

  Property<References> surfaces{this, "surfaces", {}, {.doc = "which can be picked; none: all that are made of triangles", .accepts = "renderer", .affects = Affects::nothing}};
  Property<std::vector<int>> selection{this, "selection", {}, {.min = 0, .doc = "numbers of the parts (by the array component, or connected) that are picked: a click picks one, with Shift or Ctrl adds or removes it, on the background empties this"}};
  Property<bool> show_values{this, "show_values", true, {.doc = "the window shows what was picked beside it", .affects = Affects::nothing}};
  Property<std::string> renderer{this, "renderer", {}, {.doc = "the surface of the last pick; empty: none", .group = "Last pick", .affects = Affects::nothing}};
  Property<int> part{this, "part", -1, {.min = -1, .doc = "of its split; -1: none", .group = "Last pick", .affects = Affects::nothing}};
  Property<int> component{this, "component", -1, {.min = -1, .doc = "number of its part, of the mesh as it is without splitters; of a cap the innermost that it closes; -1: none", .group = "Last pick", .affects = Affects::nothing}};
  Property<int> cell{this, "cell", -1, {.min = -1, .doc = "of the mesh; -1: none, or a cap", .group = "Last pick", .affects = Affects::nothing}};
  Property<glm::vec3> position{this, "position", glm::vec3(0), {.unit = "world", .doc = "where it was seen", .group = "Last pick", .affects = Affects::nothing}};
  Property<std::vector<std::string>> values{this, "values", {}, {.doc = "name = value of each array there; arrays of points are interpolated over the triangle", .group = "Last pick", .affects = Affects::nothing}};

  bool input(const InputEvent& event, ViewInput& view) override {
    if (event.type != InputEvent::Type::click || event.button != InputEvent::Button::left || !event.held.empty()) return false;
    const bool adds = event.shift || event.control;
    const auto picked = view.pick(event.position, surfaces->ids);
    if (picked) take(*picked, adds);
    else if (!adds) clear();
    return picked.has_value();
  }

  std::vector<Label> labels() const override {
    if (!show_values || renderer->empty()) return {};
    Label label{.position = position, .text = renderer};
    if (component >= 0) label.text += ", component " + std::to_string(component);
    if (cell >= 0) label.text += ", cell " + std::to_string(cell);
    const std::size_t shown = std::min(values->size(), most_lines);
    for (std::size_t i = 0; i < shown; ++i) label.text += "\n" + (*values)[i];
    if (shown < values->size()) label.text += "\n...";
    return {std::move(label)};
  }

 private:
  /// What stays as it is makes no undo step.
  template <class T>
  static void put(Property<T>& property, T value) {
    if (property.get() != value) property.set(std::move(value));
  }

  void take(const Picked& picked, bool adds) {
    // Where it was before a splitter moved it, in the mesh's own space.
    const glm::vec3 place = glm::inverse(picked.moved * picked.object_to_world) * glm::vec4(picked.position, 1);
    const int found = component_of(picked, place);
    put(renderer, picked.renderer);
    put(part, picked.part);
    put(component, found);
    put(cell, picked.cell);
    put(position, picked.position);
    put(values, picked.mesh == nullptr || picked.cell < 0 ? std::vector<std::string>() : pick::values_at(*picked.mesh, picked.cell, place));
    std::vector<int> chosen = adds ? *selection : std::vector<int>();
    const auto there = std::find(chosen.begin(), chosen.end(), found);
    if (there != chosen.end()) chosen.erase(there);
    else if (found >= 0) chosen.push_back(found);
    put(selection, std::move(chosen));
  }

  void clear() {
    put(renderer, std::string());
    put(part, -1);
    put(component, -1);
    put(cell, -1);
    put(values, {});
    put(selection, {});
  }

  int component_of(const Picked& picked, glm::vec3 place) {
    if (picked.mesh == nullptr || picked.mesh->triangles.empty()) return -1;
    if (grouped_.lock() != picked.mesh) {
      parts_ = parts_of(*picked.mesh);
      grouped_ = picked.mesh;
    }
    if (picked.cell < 0) return pick::part_around(*picked.mesh, parts_, place);
    const std::int64_t triangle = triangle_of_cell(*picked.mesh, picked.cell);
    return triangle < 0 ? -1 : int(parts_.of_triangle[std::size_t(triangle)]);
  }

  std::weak_ptr<const Mesh> grouped_;  ///< what the parts are of
  Grouping parts_;
};

}  // namespace

LUMEN_PLUGIN(Pick, "interactor.pick", "A click on a surface tells what is there and selects its part.")
