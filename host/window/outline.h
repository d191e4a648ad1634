/// The outline: views with what they are made of, then data, parts, and all else. Selects, enables, renames.
#pragma once

#include <functional>
#include <string>

#include <lumen/editor.h>

namespace lumenshop {

class Outline {
 public:
  /// What it cannot do through the workbench.
  struct Actions {
    std::function<void(const std::string& id, const std::string& to)> rename;
    std::function<void()> add;
  };
  /// Fills the panel's window, which is already begun.
  void draw(lumen::Workbench& workbench, const Actions& actions);
  void begin_rename(const std::string& id) { renaming_ = id; }

 private:
  void row(lumen::Workbench& workbench, const lumen::InstanceState& instance, int depth, const Actions& actions);
  bool heading(const std::string& title);
  std::string filter_, renaming_;
};

}  // namespace lumenshop
