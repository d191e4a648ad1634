/// A script for the window's tests: a person's steps as JSON, played through the input queue, one event a frame.
///
/// An array of steps; places are "panel/control" as recorded, such as "properties/ssao.radius", "outline/wall":
///   {"move": PLACE, "at": [0.5, 0.5]}                       at: within the control, default its middle
///   {"click": PLACE, "at": [..], "button": "left|right|middle", "times": 1, "keys": "Ctrl+Shift"}
///   {"drag": PLACE, "at": [..], "by": [40, 0], "button": .., "keys": .., "hold": "L", "steps": 8, "release": true}
///       or "to": PLACE, its middle
///   {"wheel": PLACE, "notches": 1, "keys": ..}
///   {"type": "0.25"}    {"key": "Ctrl+Z"}    {"drop": ["file"]}    {"command": "session.save"}    {"select": "wall"}
///   {"idle": 0.3, "frames": 0}                              waits; at most so many frames may be drawn meanwhile
///   {"settle": true}                                        waits for jobs and refinement
///   {"expect": "ssao.radius", "value": 0.25, "tolerance": 0.001, "set": true, "link": "..."}
///   {"expect_place": PLACE, "there": true}   {"expect_problems": 0}
///   {"shot": "file.ppm"}                                    the window as it is shown
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include <nlohmann/json.hpp>

#include "window/application.h"

namespace lumenshop {

class Script {
 public:
  /// Throws lumen::Error: no such file, no JSON array, over 1 MiB.
  explicit Script(const std::filesystem::path& file);

  void attach(Application& application, Gui& gui, GlfwWindow& window, InputQueue& queue);
  /// Before a frame: at most one more event into the queue. `frames`: drawn so far.
  void step(long frames);
  /// After a frame was drawn, before it is shown.
  void after_frame();
  bool finished() const { return finished_; }
  /// What did not hold, a line each.
  const std::string& failures() const { return failures_; }
  double wake_at() const;                             ///< when step() has something to do; 0 = at once

 private:
  using Json = nlohmann::json;
  struct Place { glm::vec2 min{0}, max{0}; long frame = -1; };
  void begin(const Json& step);
  void begin_pointer(const Json& step, const std::string& verb);
  void press_keys(const std::string& chord, bool down);
  void key(const std::string& name, bool down);
  void move_to(glm::vec2 position);
  void button(int index, bool down);
  void later(WindowEvent event);
  void expect(const Json& step);
  void fail(const std::string& why);
  glm::vec2 aim(const Json& step, const std::string& place);
  void write_shot();

  Json steps_;
  std::size_t next_ = 0;
  std::deque<WindowEvent> pending_;
  std::map<std::string, Place> places_;
  Application* application_ = nullptr;
  Gui* gui_ = nullptr;
  GlfwWindow* window_ = nullptr;
  InputQueue* queue_ = nullptr;
  bool control_ = false, shift_ = false, finished_ = false, settling_ = false;
  int rest_ = 0;                     ///< frames until the next step, so that what it did has been drawn
  double waiting_until_ = 0;
  long frames_ = 0, frames_allowed_ = -1, frames_at_wait_ = 0;
  std::filesystem::path shot_;
  std::string failures_;
};

}  // namespace lumenshop
