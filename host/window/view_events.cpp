// The view panel's input: window events become the interactors' events, clicks, double clicks and the menu.
#include <utility>

#include <imgui.h>

#include <lumen/ui/look.h>

#include "window/glfw_window.h"
#include "window/view_panel.h"

namespace lumenshop {
namespace {

using lumen::InputEvent;

constexpr float click_radius = 5;        // UI units that a click may move
constexpr double double_click_seconds = 0.3;

InputEvent::Button button_of(int glfw_button) {
  constexpr InputEvent::Button buttons[] = {InputEvent::Button::left, InputEvent::Button::right, InputEvent::Button::middle};
  return glfw_button >= 0 && glfw_button < 3 ? buttons[glfw_button] : InputEvent::Button::none;
}

}  // namespace

InputEvent ViewPanel::event_at(InputEvent::Type type, const WindowEvent& event) const {
  InputEvent sent;
  sent.type = type;
  sent.button = held_button_;
  sent.position = pointer_ - place_.min;
  sent.shift = event.shift;
  sent.control = event.control;
  sent.held = held_letter_;
  return sent;
}

void ViewPanel::take_events(const Context& context, bool hovered) {
  held_letter_ = context.held_letter;
  for (const WindowEvent& event : context.events) {
    switch (event.type) {
      case WindowEvent::Type::pointer: {
        const glm::vec2 before = std::exchange(pointer_, event.position);
        if (glm::distance(pointer_, pressed_at_) > click_radius * lumen::ui::look().scale) moved_ = true;
        if (!input_.captured() && !hovered) break;
        // A click that trembles does not turn the camera.
        if (input_.captured() && !moved_) break;
        InputEvent sent = event_at(InputEvent::Type::move, event);
        sent.delta = pointer_ - before;
        input_.send(sent);
        break;
      }
      case WindowEvent::Type::button: take_button(event, context, hovered); break;
      case WindowEvent::Type::wheel:
        if (hovered && event.wheel.y != 0) {
          InputEvent sent = event_at(InputEvent::Type::wheel, event);
          sent.wheel = event.wheel.y;
          wheeled_ |= input_.send(sent);
        }
        break;
      case WindowEvent::Type::focus:
        // The button may come up elsewhere: who holds a drag is told that it ended.
        if (!event.down && input_.captured()) input_.send(event_at(InputEvent::Type::release, event));
        break;
      case WindowEvent::Type::key: case WindowEvent::Type::character: case WindowEvent::Type::drop: case WindowEvent::Type::close: break;
    }
  }
}

void ViewPanel::take_button(const WindowEvent& event, const Context& context, bool hovered) {
  const InputEvent::Button button = button_of(event.button);
  if (button == InputEvent::Button::none) return;
  if (event.down) {
    if (!hovered || held_button_ != InputEvent::Button::none) return;
    held_button_ = button;
    pressed_at_ = pointer_;
    moved_ = false;
    const double now = GlfwWindow::time();
    const bool twice = button == InputEvent::Button::left && now - last_click_ < double_click_seconds &&
                       glm::distance(pointer_, last_click_at_) <= click_radius * lumen::ui::look().scale;
    if (button == InputEvent::Button::left) {
      last_click_ = twice ? -1 : now;
      last_click_at_ = pointer_;
    }
    input_.send(event_at(twice ? InputEvent::Type::double_click : InputEvent::Type::press, event));
    return;
  }
  if (button != held_button_) return;
  const bool a_tools = input_.captured_by_tool();
  const InputEvent click = event_at(InputEvent::Type::click, event);
  if (input_.captured()) input_.send(event_at(InputEvent::Type::release, event));
  held_button_ = InputEvent::Button::none;
  if (moved_ || !hovered || a_tools) return;
  if (button == InputEvent::Button::right) open_menu_ = true;
  // A second click has been a double click already.
  if (button != InputEvent::Button::left || last_click_ < 0) return;
  input_.send(click);
  // A modified one belongs to the interactors alone.
  if (event.shift || event.control || !held_letter_.empty()) return;
  context.select(view_.empty() ? std::string() : input_.instance_at(pointer_ - place_.min));
}

bool ViewPanel::key(const WindowEvent& event) {
  if (view_.empty()) return false;
  InputEvent sent = event_at(InputEvent::Type::key, event);
  sent.key = event.name;
  const bool held = input_.captured(), claimed = input_.send(sent);
  // The release of a drag that was given up is no click.
  moved_ = moved_ || (held && !input_.captured());
  return claimed;
}

}  // namespace lumenshop
