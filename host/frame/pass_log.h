/// Which passes ran, on what, and how long they took: a pass whose key is unchanged does not run again.
#pragma once

#include <chrono>
#include <map>
#include <string>
#include <vector>

#include <epoxy/gl.h>

#include "frame/view_renderer.h"

namespace lumenshop {

class PassLog {
 public:
  /// Runs `body` unless the pass's last run in this set had the same key. True if it ran.
  template <class Body>
  bool run(const std::string& name, int set, std::uint64_t key, Body&& body) {
    std::uint64_t& last = keys_[{set, name}];
    if (last == key) return false;
    last = key;
    if (timing_) glFinish();
    const auto begin = std::chrono::steady_clock::now();
    body();
    if (timing_) glFinish();
    finish(name, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
    return true;
  }
  void forget() { keys_.clear(); }
  /// The set's layers are gone: all of its passes are due.
  void forget(int set) {
    std::erase_if(keys_, [set](const auto& entry) { return entry.first.first == set; });
  }
  /// For a pass that learned while it ran what it depends on.
  void set_key(const std::string& name, int set, std::uint64_t key) { keys_[{set, name}] = key; }
  std::uint64_t total_runs() const { return total_runs_; }
  void set_timing(bool on) { timing_ = on; }
  std::vector<PassStatistics> statistics() const;  ///< in the order of their first run
  void reset();

 private:
  void finish(const std::string& name, double milliseconds);
  std::map<std::pair<int, std::string>, std::uint64_t> keys_;
  std::vector<PassStatistics> statistics_;
  std::uint64_t total_runs_ = 0;
  bool timing_ = false;
};

}  // namespace lumenshop
