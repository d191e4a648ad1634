/// The threads that run jobs, first come first served.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "jobs/run.h"

namespace lumenshop {

/// Thread: main, for all functions. Whoever owns it keeps the runs until take_finished() gives them back.
class WorkerPool {
 public:
  /// `finished` is called from a worker after each run.
  WorkerPool(int threads, std::function<void()> finished);
  ~WorkerPool();  ///< waits for the run at hand; forgets the others

  void start(std::shared_ptr<Run> run);
  std::vector<std::shared_ptr<Run>> take_finished();
  void wait_for_finished();  ///< until take_finished() has something to give; some run must be under way

 private:
  void work();

  std::function<void()> finished_callback_;
  std::mutex mutex_;
  std::condition_variable queued_, finished_changed_;
  std::deque<std::shared_ptr<Run>> queue_;
  std::vector<std::shared_ptr<Run>> finished_;
  bool stopping_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace lumenshop
