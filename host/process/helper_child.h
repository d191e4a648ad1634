/// The program's side of one child of the helper process.
#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "process/channel.h"

namespace lumenshop {

/// Destroying it kills the child. Thread: one at a time.
class HelperChild {
 public:
  HelperChild(Channel channel, lumen::Descriptor output) : channel_(std::move(channel)), output_(std::move(output)) {}

  bool send(const Message& message) const { return channel_.send(message); }  ///< false: it is dead
  bool alive() const;

  struct Watch {
    std::string subject;                            ///< what an error's message begins with: a file, a library, a module
    std::string actor;                              ///< who failed, if it is not the subject: "its reader ", or empty
    std::chrono::milliseconds time_limit;
    std::string time_limit_text;                    ///< "600 s"
    std::uint64_t memory_limit = 0;                 ///< bytes, for the message
    std::function<bool(float)> progress = {};       ///< every 50 ms at least; false cancels
  };
  /// Waits for the reply. Throws lumen::Error with the child's reason or how it died, lumen::Cancelled.
  Message wait(const Watch& watch);

 private:
  void take_output();                               ///< keeps the end of what the child printed
  [[noreturn]] void throw_death(int status, const Watch& watch);
  [[noreturn]] void throw_out_of_memory(const Watch& watch) const;
  std::string last_line() const;

  Channel channel_;
  lumen::Descriptor output_;                        ///< non-blocking read end of the child's stdout and stderr
  std::string printed_, stage_;
  bool out_of_memory_ = false;
};

}  // namespace lumenshop
