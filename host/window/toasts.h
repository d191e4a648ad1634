/// Short messages at the bottom right of the view. At most three; they go after five seconds unless the pointer rests on
/// them; errors stay; all are logged.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include <lumen/plugin.h>

#include "window/layout.h"

namespace lumenshop {

class Toasts {
 public:
  /// `details` are shown smaller, beneath. `about` is what dismiss() names: a message that no longer holds goes by itself.
  void show(lumen::Severity severity, std::string title, std::string details = {}, std::string about = {});
  void dismiss(const std::string& about);
  void draw(const Rectangle& view, bool errors_alone);
  bool empty() const { return shown_.empty(); }
  const std::vector<std::string>& log() const { return log_; }

 private:
  struct Toast {
    lumen::Severity severity;
    std::string title, details, about;
    double left = 5;  ///< seconds
  };
  std::deque<Toast> shown_;
  std::vector<std::string> log_;
  bool draw_one(Toast& toast, std::size_t index, const Rectangle& view, float& bottom);
};

}  // namespace lumenshop
