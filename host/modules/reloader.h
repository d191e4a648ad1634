/// Watches plugins and shaders, rebuilds what changed, and swaps it in between two frames or keeps the old one.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <lumen/editor.h>

#include "model/session.h"
#include "modules/registry.h"

namespace lumenshop {

/// What the frame composition does for a reload.
class FrameCheck {
 public:
  virtual ~FrameCheck() = default;
  /// Draws the current session once, off screen if need be. Returns an empty string if it was clean, else what went wrong:
  /// a GL error, a throw, NaN in the picture.
  virtual std::string try_frame() = 0;
  /// These shader files changed on disk: programs that use them are built again, the last good ones stay if they fail.
  virtual void shaders_changed(const std::vector<std::filesystem::path>& files) = 0;
};

enum class BuildState { idle, building, loaded, kept };

struct ReloadEvent {
  std::string library;      ///< file name without extension
  BuildState state;
  int generation;           ///< the one that runs
  std::string message;      ///< why it was kept
};

class Reloader {
 public:
  struct Options {
    std::filesystem::path shader_folder;     ///< watched recursively
    std::filesystem::path build_description; ///< share/lumenshop/build.json of a build tree, or empty: no building
    bool build = true;                       ///< watch sources and run the build
  };
  Reloader(Registry& registry, Session& session, FrameCheck& frame, Options options);
  ~Reloader();

  /// A descriptor that becomes readable when poll() has something to do; for the event loop.
  int descriptor() const;
  /// Takes what has happened since, without waiting: starts builds, swaps libraries and shaders. Between frames only.
  std::vector<ReloadEvent> poll();
  void build_now();                          ///< F5
  bool building() const;
  BuildState state(const std::string& library) const;
  /// Compiler messages and reasons for what was kept, until they are mended.
  std::vector<lumen::Problem> problems() const;
  /// Reloads one library from its file now: what poll() does when it changes. The reason if it was kept, else empty.
  std::string reload(const std::filesystem::path& library);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lumenshop
