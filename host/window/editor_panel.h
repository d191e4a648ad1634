/// An editor's panel: the session's instance of its type if there is one, else one of the window's own.
#pragma once

#include <string>

#include <lumen/editor.h>

#include "model/session.h"
#include "modules/registry.h"

namespace lumenshop {

class EditorPanel {
 public:
  EditorPanel(Registry& registry, std::string type);

  /// Fills the window, which is already begun. What the editor throws is shown in its place.
  void draw(Session& session, lumen::Workbench& workbench);
  /// For a tab: "Problems"; the type if no library has it.
  std::string title(Session& session);

 private:
  lumen::Editor* editor(Session& session);
  Registry& registry_;
  std::string type_;
  Session own_;               ///< holds the window's own instance: never saved
  std::string failure_;
};

}  // namespace lumenshop
