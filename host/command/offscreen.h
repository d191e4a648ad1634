/// A session drawn without a window: what render, bench and the image tests stand on.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "command/command_line.h"
#include "command/findings.h"
#include "frame/headless.h"
#include "workshop.h"

namespace lumenshop {

class Offscreen {
 public:
  struct Options {
    std::vector<std::filesystem::path> files;           ///< one session, or data
    std::vector<std::filesystem::path> plugin_folders;
    std::vector<Override> overrides;
    std::string view;                                   ///< empty = the first
    glm::ivec2 size{1280, 1024};
    std::vector<std::string> warm_workers;              ///< see Workshop
    std::vector<std::string> layers;                    ///< what finish() is for, see ViewRenderer::request(); empty = not known yet
  };
  /// Opens the files and makes the GL context while they are read; returns when all data is there. Overrides that do not
  /// fit and data that failed become findings. Throws lumen::Error if there is nothing to draw at all.
  explicit Offscreen(const Options& options);
  ~Offscreen();

  Workshop& workshop() { return *workshop_; }
  ViewRenderer& view() { return *view_; }
  /// Draws the session anew after it was loaded again and the views were closed.
  void reopen();
  /// Brings links and data up to date, and draws all refinements.
  void finish();
  /// Drops views and session, jobs and exporters go on; then the GL context. Nothing is drawn again.
  void drop_scene();
  void drop_context();
  Findings& findings() { return findings_; }
  /// Findings with all that the session, its data and its shaders have to say by now.
  Findings all_findings() const;

 private:
  std::optional<HeadlessContext> context_;  // declared first: plugins free their GL objects when the workshop goes
  std::unique_ptr<Workshop> workshop_;
  std::string view_id_;
  glm::ivec2 size_;
  ViewRenderer* view_ = nullptr;
  Findings findings_;
};

}  // namespace lumenshop
