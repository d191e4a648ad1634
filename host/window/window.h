/// The program's window: opens it over a workshop and runs it until it is closed.
#pragma once

#include <filesystem>
#include <vector>

#include <glm/vec2.hpp>

#include "workshop.h"

namespace lumenshop {

struct WindowSetup {
  std::vector<std::filesystem::path> files;  ///< a session, or data
  glm::ivec2 size{1440, 900};                ///< pixels
  std::filesystem::path script;              ///< see script.h; empty = a person uses it. With a script no settings are read or kept
};

/// For Workshop::Options::wake: lets the window look at what a job has done. Thread: any.
void wake_window();

/// 0, or 1 if a script's expectation failed (which is printed). Throws lumen::Error: no display, no GL 4.5.
int show_window(Workshop& workshop, const WindowSetup& setup);

}  // namespace lumenshop
