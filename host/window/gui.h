/// Dear ImGui on the window: its context, input, fonts and style, and the look that panels find on it.
#pragma once

#include <vector>

#include <lumen/ui/look.h>

#include "window/glfw_window.h"

namespace lumenshop {

class Gui {
 public:
  /// The window's GL context must be current, then and whenever this goes.
  explicit Gui(GlfwWindow& window);
  ~Gui();
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;

  /// Colors and sizes; fonts are built again when the scale differs. `scale`: pixels per UI unit.
  void set_look(lumen::ui::Theme theme, float scale, bool reduced_motion);
  lumen::ui::Look& look() { return look_; }

  void begin(const std::vector<WindowEvent>& events);  ///< a frame
  void end();                                          ///< draws it to the default framebuffer

  /// When a control asked for a frame though nothing happens, as GlfwWindow::time(); 0 = never.
  double wake_at() const;

  /// A letter that is held down, such as "L"; empty if none is.
  const std::string& held_letter() const { return held_; }

 private:
  GlfwWindow& window_;
  lumen::ui::Look look_;
  lumen::ui::Theme theme_ = lumen::ui::Theme::dark;
  double last_time_ = 0;
  std::string held_;
  void feed(const WindowEvent& event);
};

}  // namespace lumenshop
