#include "window/input_queue.h"

#include <algorithm>
#include <array>
#include <utility>

#include <GLFW/glfw3.h>

namespace lumenshop {
namespace {

constexpr std::array<std::pair<int, const char*>, 40> named_keys{{
    {GLFW_KEY_SPACE, "Space"}, {GLFW_KEY_APOSTROPHE, "Apostrophe"}, {GLFW_KEY_COMMA, "Comma"}, {GLFW_KEY_MINUS, "Minus"},
    {GLFW_KEY_PERIOD, "Period"}, {GLFW_KEY_SLASH, "Slash"}, {GLFW_KEY_SEMICOLON, "Semicolon"}, {GLFW_KEY_EQUAL, "Plus"},
    {GLFW_KEY_LEFT_BRACKET, "BracketLeft"}, {GLFW_KEY_RIGHT_BRACKET, "BracketRight"}, {GLFW_KEY_GRAVE_ACCENT, "Grave"},
    {GLFW_KEY_ESCAPE, "Esc"}, {GLFW_KEY_ENTER, "Enter"}, {GLFW_KEY_TAB, "Tab"}, {GLFW_KEY_BACKSPACE, "Backspace"},
    {GLFW_KEY_INSERT, "Insert"}, {GLFW_KEY_DELETE, "Del"}, {GLFW_KEY_RIGHT, "Right"}, {GLFW_KEY_LEFT, "Left"},
    {GLFW_KEY_DOWN, "Down"}, {GLFW_KEY_UP, "Up"}, {GLFW_KEY_PAGE_UP, "PageUp"}, {GLFW_KEY_PAGE_DOWN, "PageDown"},
    {GLFW_KEY_HOME, "Home"}, {GLFW_KEY_END, "End"}, {GLFW_KEY_KP_DECIMAL, "Period"}, {GLFW_KEY_KP_DIVIDE, "Slash"},
    {GLFW_KEY_KP_SUBTRACT, "Minus"}, {GLFW_KEY_KP_ADD, "Plus"}, {GLFW_KEY_KP_ENTER, "Enter"}, {GLFW_KEY_LEFT_SHIFT, "Shift"},
    {GLFW_KEY_RIGHT_SHIFT, "Shift"}, {GLFW_KEY_LEFT_CONTROL, "Ctrl"}, {GLFW_KEY_RIGHT_CONTROL, "Ctrl"}, {GLFW_KEY_LEFT_ALT, "Alt"},
    {GLFW_KEY_RIGHT_ALT, "Alt"}, {GLFW_KEY_LEFT_SUPER, "Super"}, {GLFW_KEY_RIGHT_SUPER, "Super"}, {GLFW_KEY_MENU, "Menu"},
    {GLFW_KEY_PRINT_SCREEN, "Print"}}};

bool same_control(const WindowEvent& a, const WindowEvent& b) {
  if (a.type != b.type) return false;
  if (a.type == WindowEvent::Type::button) return a.button == b.button;
  return a.type == WindowEvent::Type::key && a.key == b.key;
}

/// Whether `next` would hide what `taken` already holds.
bool collides(const std::vector<WindowEvent>& taken, const WindowEvent& next) {
  using Type = WindowEvent::Type;
  const auto any = [&](auto condition) { return std::any_of(taken.begin(), taken.end(), condition); };
  const auto is_button = [](const WindowEvent& event) { return event.type == Type::button; };
  switch (next.type) {
    case Type::pointer: return any(is_button);
    case Type::button: return any(is_button) || any([](const WindowEvent& event) { return event.type == Type::key; });
    case Type::key: return any([&](const WindowEvent& event) { return same_control(event, next); }) || any(is_button);
    case Type::character: return false;
    case Type::wheel: return any(is_button);
    case Type::drop: case Type::focus: case Type::close: return !taken.empty();
  }
  return false;
}

}  // namespace

std::vector<WindowEvent> InputQueue::take_frame() {
  std::vector<WindowEvent> taken;
  while (!events_.empty() && !collides(taken, events_.front())) {
    // Of a run of moves only the last one counts; interactors look at positions, not at steps.
    if (events_.front().type == WindowEvent::Type::pointer && !taken.empty() && taken.back().type == WindowEvent::Type::pointer) taken.pop_back();
    taken.push_back(std::move(events_.front()));
    events_.pop_front();
  }
  return taken;
}

std::string name_of_key(int key) {
  if ((key >= GLFW_KEY_A && key <= GLFW_KEY_Z) || (key >= GLFW_KEY_0 && key <= GLFW_KEY_9)) return std::string(1, static_cast<char>(key));
  if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9) return std::string(1, static_cast<char>('0' + key - GLFW_KEY_KP_0));
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) return "F" + std::to_string(key - GLFW_KEY_F1 + 1);
  const auto found = std::find_if(named_keys.begin(), named_keys.end(), [&](const auto& entry) { return entry.first == key; });
  return found == named_keys.end() ? "" : found->second;
}

int key_of_name(const std::string& name) {
  for (int key = GLFW_KEY_SPACE; key <= GLFW_KEY_LAST; ++key)
    if (name_of_key(key) == name) return key;
  return 0;
}

}  // namespace lumenshop
