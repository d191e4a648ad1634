/// Runs the build of a build tree in the background.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

#include <lumen/descriptor.h>

namespace lumenshop {

/// share/lumenshop/build.json: {"sources": FOLDER, "build": FOLDER, "command": [PROGRAM, ARGUMENTS...]}.
struct BuildDescription {
  std::filesystem::path sources, build;
  std::vector<std::string> command;
  /// Throws lumen::Error.
  static BuildDescription load(const std::filesystem::path& file);
};

/// Thread: one at a time.
class Builder {
 public:
  explicit Builder(BuildDescription description);
  ~Builder();   ///< ends a running build
  Builder(const Builder&) = delete;
  Builder& operator=(const Builder&) = delete;

  /// Starts a build; one that runs is ended and followed by another, since it may have read older sources. Throws lumen::Error.
  void start();
  bool running() const { return process_ >= 0; }
  const BuildDescription& description() const { return description_; }

  struct Outcome {
    bool success;
    std::string output;   ///< its last MiB
  };
  /// The outcome of a build that has ended since, without waiting. Throws lumen::Error if the next one does not start.
  std::optional<Outcome> poll();
  /// Readable when poll() has something to do.
  int descriptor() const { return events_.get(); }

 private:
  void spawn_build();
  void take_output();
  void end_group(int signal) const;

  BuildDescription description_;
  lumen::Descriptor events_, output_, exit_;
  pid_t process_ = -1;
  bool again_ = false;
  std::string text_;
};

}  // namespace lumenshop
