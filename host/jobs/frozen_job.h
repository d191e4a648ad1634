/// A job: the frozen values of one instance, and what its code hands back.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <lumen/job.h>

#include "model/instance.h"

namespace lumenshop {

class Helper;

/// The values of all slots at one moment. Made on the main thread, read by any.
struct Snapshot {
  struct Entry {
    lumen::Value value;
    bool output = false;
    lumen::DataKind data_kind = lumen::DataKind::mesh;
    std::string property;
  };
  std::string instance;
  std::vector<Entry> slots;
  static Snapshot of(const Instance& instance);
};

class FrozenJob final : public lumen::Job {
 public:
  struct Report {
    lumen::Severity severity;
    std::string message;
  };
  /// `proceed` gets the fraction and answers whether to go on. Called on the thread that works.
  FrozenJob(Snapshot snapshot, Helper* helper, std::function<bool(float)> proceed);

  // lumen::Job
  void progress(float fraction) override;
  void report(lumen::Severity severity, const std::string& message) override;
  /// The worker's notes become reports.
  lumen::WorkerReply run(const lumen::WorkerRequest& request) override;
  /// Checks the data, a copy of which it keeps; throws lumen::Error if it is ill-formed or fits no output.
  void write(int slot, lumen::DataPointer data) override;

  const Snapshot& snapshot() const { return snapshot_; }
  const std::vector<Report>& reports() const { return reports_; }
  const lumen::DataPointer& result(std::size_t slot) const { return results_[slot]; }

 private:
  const lumen::Value& read(int slot) const override;

  Snapshot snapshot_;
  Helper* helper_;
  std::function<bool(float)> proceed_;
  std::vector<Report> reports_;
  std::vector<lumen::DataPointer> results_;
};

/// Calls `work` and tells how it ended.
struct Outcome {
  enum class State { done, failed, cancelled } state = State::done;
  std::string message;   ///< why it failed
  static Outcome of(const std::function<void()>& work);
};

}  // namespace lumenshop
