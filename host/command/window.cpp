/// `lumenshop [SESSION | DATA...]`: the window.
#include "window/window.h"

#include "command/commands.h"
#include "workshop.h"

namespace lumenshop {

int run_window(const WindowOptions& options, const std::vector<std::filesystem::path>& plugin_folders) {
  Workshop workshop({.plugin_folders = plugin_folders, .wake = wake_window});
  return show_window(workshop, {.files = options.files, .size = options.size, .script = options.script});
}

}  // namespace lumenshop
