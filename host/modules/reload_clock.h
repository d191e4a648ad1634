/// Waits until changes have settled: one save is several events, and a file may still be in the making at the first.
#pragma once

#include <chrono>

#include <lumen/descriptor.h>

namespace lumenshop {

class ReloadClock {
 public:
  ReloadClock();   ///< throws lumen::Error

  void changed();  ///< something changed now
  void stop();     ///< nothing is waited for
  /// Nothing has changed for 10 ms, or the first change is 100 ms old.
  bool settled() const;
  /// Readable when that is so.
  int descriptor() const { return timer_.get(); }

 private:
  using Clock = std::chrono::steady_clock;
  void arm(Clock::duration after) const;

  lumen::Descriptor timer_;
  bool waiting_ = false;
  Clock::time_point first_, due_;
};

}  // namespace lumenshop
