/// A panel's window: placed by the host, undecorated.
#pragma once

#include <string>

#include "window/layout.h"

namespace lumenshop {

/// Begins an ImGui window over the rectangle and ends it with the scope; its name prefixes recorded places.
class PanelWindow {
 public:
  PanelWindow(const char* name, const Rectangle& place, bool padded = true);
  ~PanelWindow();
  PanelWindow(const PanelWindow&) = delete;
  PanelWindow& operator=(const PanelWindow&) = delete;
};

/// Handles between panels. True if a size changed for good: the drag ended, or a double click took the default.
bool drag_splitters(const Layout& layout, float scale, PanelSizes& sizes);

}  // namespace lumenshop
