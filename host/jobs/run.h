/// One run of an instance's compute(): from the request to the adoption of its result.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <string>

#include <lumen/importer.h>

#include "jobs/frozen_job.h"

namespace lumenshop {

/// Made and destroyed on the main thread, as the plugin object that it keeps alive must be. compute() runs on a worker.
class Run {
 public:
  Run(std::shared_ptr<lumen::Plugin> object, Snapshot snapshot, std::string title, Helper* helper);

  void compute();                                  ///< thread: a worker's
  void cancel() { cancelled_ = true; }             ///< thread: any
  bool cancelled() const { return cancelled_; }
  float fraction() const { return fraction_; }
  double seconds() const;                          ///< since the request

  const std::shared_ptr<lumen::Plugin>& object() const { return object_; }
  const std::string& title() const { return title_; }
  // Once compute() has returned:
  const FrozenJob& job() const { return job_; }
  const Outcome& outcome() const { return outcome_; }

 private:
  std::shared_ptr<lumen::Plugin> object_;
  std::string title_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::atomic<bool> cancelled_ = false;
  std::atomic<float> fraction_ = 0;
  FrozenJob job_;
  Outcome outcome_;
};

}  // namespace lumenshop
