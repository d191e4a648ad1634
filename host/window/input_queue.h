/// The one queue of input: the window's callbacks or a script fill it; ImGui and the interactors are fed from it.
#pragma once

#include <deque>
#include <filesystem>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace lumenshop {

/// One thing that a person (or a script) did. Positions in pixels of the window, origin top left.
struct WindowEvent {
  enum class Type { pointer, button, wheel, key, character, drop, focus, close };
  Type type = Type::pointer;
  glm::vec2 position{0};      ///< pointer
  int button = 0;             ///< 0 left, 1 right, 2 middle
  bool down = false;          ///< button, key; focus gained
  bool repeated = false;      ///< key: held
  glm::vec2 wheel{0};         ///< notches
  int key = 0;                ///< GLFW's key code
  std::string name;           ///< of the key on the person's keyboard: "A", "F12", "Left", "Period"; keypad digits as digits
  bool shift = false, control = false;
  unsigned character = 0;     ///< Unicode
  std::vector<std::filesystem::path> files;  ///< drop
};

class InputQueue {
 public:
  void push(WindowEvent event) { events_.push_back(std::move(event)); }
  bool empty() const { return events_.empty(); }
  /// The next events that one frame can take without losing one: a button or key changes at most once, and the pointer
  /// does not move after a button did.
  std::vector<WindowEvent> take_frame();

 private:
  std::deque<WindowEvent> events_;
};

/// The name of a GLFW key by itself, on a US keyboard; empty for keys without one here.
std::string name_of_key(int key);
/// The GLFW key of such a name; 0 if there is none.
int key_of_name(const std::string& name);

}  // namespace lumenshop
