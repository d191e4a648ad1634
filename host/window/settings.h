/// What the person chose for the window, kept in $XDG_CONFIG_HOME/lumenshop/ui.json; never in sessions.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <lumen/ui/palette.h>

#include "window/layout.h"

namespace lumenshop {

struct Settings {
  PanelSizes panels;
  lumen::ui::Theme theme = lumen::ui::Theme::dark;
  std::string bottom_panel = "problems";  ///< an editor's name; one that is not there shows the problems
  float user_scale = 1;            ///< 0.75..3, times the monitor's
  bool blender_keys = false;
  bool reduced_motion = false;
  std::vector<std::string> recent;  ///< sessions, newest first, at most 10

  /// The file's settings; defaults for what it lacks or what makes no sense. Never throws.
  static Settings load(const std::filesystem::path& file);
  /// Atomically. Never throws: settings are not worth a message.
  void save(const std::filesystem::path& file) const;
  void remember(const std::filesystem::path& session);
};

}  // namespace lumenshop
