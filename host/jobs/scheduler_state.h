/// What the scheduler knows of each plugin object, and how it decides.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "jobs/run.h"
#include "jobs/scheduler.h"
#include "jobs/worker_pool.h"

namespace lumenshop {

/// What all that compute() reads had as revisions: another key, other results.
using Key = std::vector<std::uint64_t>;

/// Whether what an instance reads is there.
struct Inputs {
  enum class State { ready, busy, blocked } state = State::ready;
  std::string why;  ///< blocked: "waits for scan.mesh, which failed"
};

/// Thread: main.
struct Scheduler::State {
  /// A reload makes a new object, which has no record yet and so is due by itself.
  struct Record {
    std::optional<Key> started;  ///< of the last job; none = due
    std::shared_ptr<Run> run;    ///< under way
    std::string failure;         ///< of the last job; empty = none
    bool stopped = false;        ///< a person cancelled the run: not due until something changes
  };
  using Records = std::map<std::weak_ptr<lumen::Plugin>, Record, std::owner_less<std::weak_ptr<lumen::Plugin>>>;

  State(Session& session, Helper* helper, std::function<void()> wake);

  Instance* find(const std::shared_ptr<lumen::Plugin>& object) const;  ///< null if it is in the session no longer
  bool any_running() const;
  Inputs inputs_of(const Instance& instance, std::vector<const Instance*> path = {}) const;
  /// Takes over what a finished run made. False if no data came of it.
  bool adopt(const std::shared_ptr<Run>& run);
  /// Starts the instance's job if one is due and possible.
  void consider(Instance& instance);

  Session& session;
  Helper* helper;
  Records records;
  WorkerPool pool;  ///< last: its threads end first

 private:
  Inputs output_of(const Instance& source, const std::string& property, const std::vector<const Instance*>& path) const;
};

}  // namespace lumenshop
