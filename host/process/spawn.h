/// Starts programs: with exactly the descriptors they shall have, default signals, and no fork of this process.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <sys/types.h>

namespace lumenshop {

struct SpawnOptions {
  std::vector<std::string> arguments;   ///< the program first; found in $PATH if it has no slash
  std::filesystem::path folder = {};    ///< where it works; empty = where we do
  int output = -1;                      ///< becomes its stdout and stderr; -1 = /dev/null
  int channel = -1;                     ///< becomes its descriptor 3; -1 = none
  bool own_group = false;               ///< so that it can be ended with all that it starts
};

/// The process that runs it; the caller waits for its end. Throws lumen::Error. Thread: any.
pid_t spawn(const SpawnOptions& options);

}  // namespace lumenshop
