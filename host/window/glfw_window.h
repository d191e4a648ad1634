/// The native window with its GL 4.5 context; its callbacks fill the input queue.
#pragma once

#include <string>

#include <glm/vec2.hpp>

#include "window/input_queue.h"

struct GLFWwindow;

namespace lumenshop {

class GlfwWindow {
 public:
  /// Makes the context current on this thread. Throws lumen::Error with the reason and what to do (no display, no GL 4.5).
  GlfwWindow(glm::ivec2 size, const std::string& title, InputQueue& queue);
  ~GlfwWindow();
  GlfwWindow(const GlfwWindow&) = delete;
  GlfwWindow& operator=(const GlfwWindow&) = delete;

  glm::ivec2 size() const;               ///< pixels
  float content_scale() const;           ///< of the monitor: 1, 1.5, 2
  void set_title(const std::string& title);
  void set_cursor(int imgui_cursor);     ///< ImGuiMouseCursor_...; -1 hides it
  void set_full_screen(bool on);
  bool full_screen() const { return full_screen_; }
  void swap();
  GLFWwindow* handle() const { return window_; }

  /// Waits for events: 0 seconds only takes what there is, a negative time waits for ever.
  static void wait(double seconds);
  /// Ends a wait from any thread; does nothing before the first window.
  static void wake();
  static double time();                  ///< seconds, steady

 private:
  GLFWwindow* window_ = nullptr;
  InputQueue& queue_;
  bool full_screen_ = false;
  int cursor_ = 0;
  glm::ivec2 windowed_position_{0}, windowed_size_{0};
  void* cursors_[9] = {};
};

}  // namespace lumenshop
