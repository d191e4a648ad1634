/// The helper process itself: forks a child for each piece of work and tells the program how the child ended.
///
/// It loads nothing and has one thread, so its forks are cheap and sound. A child lives no longer than the program's end of
/// its channel; all end with the program.
#pragma once

#include <filesystem>
#include <vector>

#include <sys/types.h>

#include "process/channel.h"

namespace lumenshop {

class Zygote {
 public:
  Zygote(Channel program, std::filesystem::path workers_folder);
  ~Zygote();
  void run();  ///< until the program is gone

 private:
  struct Child {
    pid_t process;
    Channel channel;      ///< the same end as the child's: to speak for it when it is dead, to see when the program hangs up
    bool killed = false;
  };
  bool take_order();      ///< false: the program is gone
  void start_child(Message order);
  void reap();

  Channel program_;
  std::filesystem::path workers_folder_;
  lumen::Descriptor signals_;
  std::vector<Child> children_;
};

}  // namespace lumenshop
