#include "window/view_input.h"

#include <algorithm>
#include <cmath>

#include <lumen/renderer.h>

#include "model/view.h"

namespace lumenshop {

using lumen::InputEvent;
using lumen::Kind;

std::vector<Instance*> ViewInputRouter::order() const {
  std::vector<Instance*> order;
  const Instance* instance = situation_.session->find(situation_.view);
  const auto* view = instance ? instance->as<View>(Kind::view) : nullptr;
  if (!view) return order;
  const auto add = [&](const std::string& id) {
    Instance* candidate = situation_.session->find(id);
    const bool usable = candidate && candidate->enabled() && candidate->as<lumen::Interactor>(Kind::interactor);
    if (usable && std::find(order.begin(), order.end(), candidate) == order.end()) order.push_back(candidate);
  };
  const std::string& camera = view->camera->id;
  const auto& lights = view->lights->ids;
  // Of several lights the selected one is meant.
  if (std::find(lights.begin(), lights.end(), situation_.selection) != lights.end()) add(situation_.selection);
  for (const std::string& id : view->interactors->ids)
    if (id != camera) add(id);
  for (const std::string& id : lights)
    if (id != camera) add(id);
  add(camera);
  return order;
}

bool ViewInputRouter::ask(Instance& instance, const InputEvent& event) {
  auto* interactor = instance.as<lumen::Interactor>(Kind::interactor);
  asked_ = instance.id();
  try {
    return interactor->input(event, *this);
  } catch (const std::exception& error) {
    instance.report(lumen::Severity::error, std::string("input failed: ") + error.what());
  }
  return false;
}

bool ViewInputRouter::send(const InputEvent& event) {
  if (!situation_.renderer) return false;
  if (event.type == InputEvent::Type::move) cursor_ = lumen::Cursor::arrow;
  if (captured()) {
    Instance* owner = situation_.session->find(captured_by_);
    const bool claimed = owner && owner->as<lumen::Interactor>(Kind::interactor) && ask(*owner, event);
    if (claimed && event.type == InputEvent::Type::key && event.key == "Esc") situation_.session->cancel_edit();
    else if (event.type != InputEvent::Type::release && owner) return true;
    let_go();
    return true;
  }
  const bool press = event.type == InputEvent::Type::press;
  const bool one_step = press || event.type == InputEvent::Type::click || event.type == InputEvent::Type::double_click;
  for (Instance* instance : order()) {
    // Opened first: what a press does at once belongs to the drag's step.
    if (one_step) situation_.session->begin_edit();
    const bool claimed = ask(*instance, event);
    if (claimed && press) captured_by_ = instance->id();
    else if (one_step) situation_.session->end_edit();
    if (claimed) return true;
  }
  return false;
}

bool ViewInputRouter::captured_by_tool() const {
  const Instance* instance = captured() ? situation_.session->find(captured_by_) : nullptr;
  const auto* interactor = instance == nullptr ? nullptr : instance->as<lumen::Interactor>(lumen::Kind::interactor);
  return interactor != nullptr && !interactor->is_camera();
}

void ViewInputRouter::let_go() {
  if (!captured()) return;
  captured_by_.clear();
  situation_.session->end_edit();
}

bool ViewInputRouter::tick() {
  const std::vector<std::string> moving = std::exchange(animated_, {});
  for (const std::string& id : moving) {
    Instance* instance = situation_.session->find(id);
    auto* interactor = instance ? instance->as<lumen::Interactor>(Kind::interactor) : nullptr;
    if (!interactor || !situation_.renderer) continue;
    asked_ = id;
    try {
      interactor->tick(*this);
    } catch (const std::exception& error) {
      instance->report(lumen::Severity::error, std::string("animation failed: ") + error.what());
    }
  }
  return animating();
}

void ViewInputRouter::animate() {
  if (std::find(animated_.begin(), animated_.end(), asked_) == animated_.end()) animated_.push_back(asked_);
}

std::vector<ViewInputRouter::PlacedLabel> ViewInputRouter::labels() const {
  std::vector<PlacedLabel> labels;
  if (!situation_.renderer) return labels;
  const lumen::Camera& eye = camera();
  for (const Instance* instance : order())
    for (lumen::Label& label : instance->as<lumen::Interactor>(Kind::interactor)->labels()) {
      const glm::vec3 seen = eye.view * glm::vec4(label.position, 1);
      if (!eye.orthographic && seen.z >= 0) continue;
      const float visible = eye.orthographic ? eye.height : -2 * seen.z * std::tan(glm::radians(0.5f * eye.field_of_view));
      const glm::vec2 size(situation_.size);
      labels.push_back({instance->id(), std::move(label.text), 0.5f * size + glm::vec2(seen.x, -seen.y) * (size.y / visible)});
    }
  return labels;
}

lumen::Bounds ViewInputRouter::selection() const {
  const Instance* instance = situation_.session->find(situation_.selection);
  const auto* renderer = instance ? instance->as<lumen::Renderer>(Kind::renderer) : nullptr;
  const lumen::Bounds bounds = renderer ? renderer->bounds() : lumen::Bounds{};
  return bounds.empty() ? scene() : bounds;
}

ViewRenderer::Hit ViewInputRouter::hit(glm::vec2 pixel, const std::function<bool(const Instance&)>& wanted) {
  // The renderer may be at a lower resolution while something moves.
  const glm::vec2 scale = glm::vec2(situation_.renderer->size()) / glm::vec2(situation_.size);
  const glm::ivec2 last = situation_.renderer->size() - 1;
  return situation_.renderer->pick(glm::clamp(glm::ivec2(pixel * scale), glm::ivec2(0), last), wanted);
}

std::optional<glm::vec3> ViewInputRouter::surface_at(glm::vec2 pixel) {
  const auto under = hit(pixel);
  if (under.instance == 0) return std::nullopt;
  return under.position;
}

Instance* ViewInputRouter::instance_of(int number) const {
  for (const auto& plugin : situation_.session->plugins())
    if (number > 0 && plugin->number() == number) return plugin.get();
  return nullptr;
}

std::string ViewInputRouter::instance_at(glm::vec2 pixel) {
  const Instance* instance = instance_of(hit(pixel).instance);
  return instance == nullptr ? std::string() : instance->id();
}

std::optional<lumen::Picked> ViewInputRouter::pick(glm::vec2 pixel, const std::vector<std::string>& renderers) {
  const ViewRenderer::Hit under = hit(pixel, [&](const Instance& renderer) {
    if (renderers.empty()) return renderer.as<lumen::Renderer>(Kind::renderer)->traced().mesh != nullptr;
    return std::find(renderers.begin(), renderers.end(), renderer.id()) != renderers.end();
  });
  Instance* instance = instance_of(under.instance);
  if (instance == nullptr) return std::nullopt;
  const lumen::TracedSurface surface = instance->as<lumen::Renderer>(Kind::renderer)->traced();
  return lumen::Picked{.renderer = instance->id(), .part = under.part - 1, .moved = under.moved, .cell = under.primitive - 1, .position = under.position,
                       .mesh = surface.mesh, .object_to_world = surface.object_to_world};
}

}  // namespace lumenshop
