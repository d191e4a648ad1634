/// Runs compute() of importers and filters on worker threads, when something that they read has changed.
#pragma once

#include <functional>
#include <future>
#include <memory>
#include <string>
#include <vector>

#include "model/session.h"

namespace lumenshop {

class Helper;

struct JobStatus {
  std::string instance;
  std::string title;        ///< "scan: reading aorta.vtp"
  float fraction = 0;       ///< 0..1
  double seconds = 0;       ///< running since
};

class Scheduler {
 public:
  /// `wake` is called from worker threads when update() has something to do.
  Scheduler(Session& session, Helper* helper, std::function<void()> wake = {});
  ~Scheduler();             ///< cancels and waits

  /// Between frames: adopts finished data, starts what is due; a newer request cancels the older. True if data changed.
  bool update();
  /// Until nothing is due or running any more (render, bench, tests).
  void wait();
  std::vector<JobStatus> running() const;
  void cancel(const std::string& instance);
  /// Runs an exporter's write() to its end. Throws lumen::Error.
  void run_export(Instance& exporter, const std::function<bool(float)>& progress = {});
  /// The same with data that is in no session: the input that takes it is given `data`, `path` is given `file`.
  void write_file(Instance& exporter, lumen::DataPointer data, const std::filesystem::path& file);
  /// The same beside what this thread does meanwhile; the exporter stays until then. get(), on this thread, waits and throws.
  std::future<void> start_writing(Instance& exporter, lumen::DataPointer data, const std::filesystem::path& file);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lumenshop
