/// What a control did to its value in one frame, and how that becomes undo steps.
#pragma once

#include <string>

#include <lumen/editor.h>

namespace lumen::ui {

struct Edit {
  bool changed = false;    ///< the value is another one now
  bool active = false;     ///< the person is at it: all changes until it ends are one undo step
  bool cancelled = false;  ///< back to the value at its beginning
  bool nudged = false;     ///< a step by wheel or key: those within 0.7 s are one undo step
  std::string new_type;    ///< an instance of it is to be added, and to be referred to: both are one undo step

  Edit& operator|=(const Edit& other) {
    changed |= other.changed;
    active |= other.active;
    cancelled |= other.cancelled;
    nudged |= other.nudged;
    if (new_type.empty()) new_type = other.new_type;
    return *this;
  }
};

/// Passes a control's edit of property `path` on to the workbench. Refusals become the look's notice.
void carry_out(Workbench& workbench, const std::string& path, const Edit& edit, const Value& value);

/// Ends the edit whose control is no longer at work or no longer drawn. Once per frame, after all panels.
void settle(Workbench& workbench);

/// The same at once: before undo, save, or a change of session.
void settle_now(Workbench& workbench);

}  // namespace lumen::ui
