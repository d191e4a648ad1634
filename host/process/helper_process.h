/// The program's side of the helper process: starts it, starts it again when it has died, asks it for children.
#pragma once

#include <filesystem>
#include <mutex>

#include <sys/types.h>

#include "process/helper_child.h"

namespace lumenshop {

/// Thread: any.
class HelperProcess {
 public:
  /// Throws lumen::Error if it cannot be started.
  HelperProcess(std::filesystem::path executable, std::filesystem::path workers_folder);
  ~HelperProcess();
  HelperProcess(const HelperProcess&) = delete;
  HelperProcess& operator=(const HelperProcess&) = delete;

  /// A child that waits for its work. Throws lumen::Error.
  HelperChild fork_child();
  pid_t process() const;   ///< changes when it was started again

 private:
  void start();
  void stop();

  const std::filesystem::path executable_, workers_folder_;
  mutable std::mutex mutex_;
  Channel channel_;
  pid_t process_ = -1;
};

}  // namespace lumenshop
