/// Updates between frames, waiting, and exports.
#include "jobs/scheduler.h"

#include <lumen/exporter.h>

#include "jobs/scheduler_state.h"

namespace lumenshop {

namespace {

/// An exporter's write(), which any thread can run, between a beginning and an end on the main thread.
class Writing {
 public:
  Writing(Instance& exporter, Snapshot snapshot, Helper* helper, std::function<bool(float)> progress)
      : exporter_(exporter), code_(exporter.as<lumen::Exporter>(lumen::Kind::exporter)), keeps_alive_(exporter.share()),
        job_(std::move(snapshot), helper, std::move(progress)) {
    if (!code_) throw lumen::Error(exporter.id(), exporter.type() + " is no exporter");
  }

  void run() {
    outcome_ = Outcome::of([&] { code_->write(job_); });
  }
  /// The same on a thread of its own.
  void start() {
    running_ = std::async(std::launch::async, [this] { run(); });
  }

  void finish() {
    if (running_.valid()) running_.get();
    for (const auto& report : job_.reports()) exporter_.report(report.severity, report.message);
    if (outcome_.state == Outcome::State::failed) throw lumen::Error(outcome_.message);
    if (outcome_.state == Outcome::State::cancelled) throw lumen::Error(exporter_.id(), "cancelled; nothing was written");
  }

 private:
  Instance& exporter_;
  const lumen::Exporter* code_;
  std::shared_ptr<lumen::Plugin> keeps_alive_;
  FrozenJob job_;
  Outcome outcome_;
  std::future<void> running_;  // last: it waits when it goes
};

}  // namespace

Scheduler::Scheduler(Session& session, Helper* helper, std::function<void()> wake)
    : state_(std::make_unique<State>(session, helper, std::move(wake))) {}

Scheduler::~Scheduler() {
  for (auto& [object, record] : state_->records)
    if (record.run) record.run->cancel();
}

bool Scheduler::update() {
  bool changed = false;
  for (const std::shared_ptr<Run>& run : state_->pool.take_finished()) changed |= state_->adopt(run);
  if (changed) state_->session.update();  // what plugins make of new data, as defaults, belongs to the jobs that read it
  for (const auto& [object, record] : state_->records)
    if (record.run && !state_->find(record.run->object())) record.run->cancel();
  for (const auto& instance : state_->session.plugins()) state_->consider(*instance);
  std::erase_if(state_->records, [](const auto& entry) { return entry.first.expired(); });
  return changed;
}

void Scheduler::wait() {
  for (update(); state_->any_running(); update()) state_->pool.wait_for_finished();
}

std::vector<JobStatus> Scheduler::running() const {
  std::vector<JobStatus> result;
  for (const auto& [object, record] : state_->records) {
    if (!record.run) continue;
    const Instance* instance = state_->find(record.run->object());
    result.push_back({instance ? instance->id() : record.run->job().snapshot().instance, record.run->title(), record.run->fraction(), record.run->seconds()});
  }
  return result;
}

void Scheduler::cancel(const std::string& instance) {
  const Instance* found = state_->session.find(instance);
  const auto record = found ? state_->records.find(found->share()) : state_->records.end();
  if (record == state_->records.end() || !record->second.run) return;
  record->second.stopped = true;
  record->second.run->cancel();
}

void Scheduler::run_export(Instance& exporter, const std::function<bool(float)>& progress) {
  Inputs inputs;
  for (;;) {
    update();
    inputs = state_->inputs_of(exporter);
    if (inputs.state != Inputs::State::busy || !state_->any_running()) break;
    state_->pool.wait_for_finished();
  }
  if (inputs.state != Inputs::State::ready) throw lumen::Error(exporter.id(), inputs.why.empty() ? "its input is not ready" : inputs.why);
  exporter.clear_reports();
  Writing writing(exporter, Snapshot::of(exporter), state_->helper, [&](float fraction) { return !progress || progress(fraction); });
  writing.run();
  writing.finish();
}

void Scheduler::write_file(Instance& exporter, lumen::DataPointer data, const std::filesystem::path& file) {
  start_writing(exporter, std::move(data), file).get();
}

std::future<void> Scheduler::start_writing(Instance& exporter, lumen::DataPointer data, const std::filesystem::path& file) {
  if (!data) throw lumen::Error(file.string(), "there is no data to write");
  Snapshot snapshot = Snapshot::of(exporter);
  bool taken = false;
  for (Snapshot::Entry& entry : snapshot.slots) {
    if (std::holds_alternative<lumen::DataPointer>(entry.value)) {
      const bool takes = !taken && !entry.output && entry.data_kind == data->kind();
      entry.value = takes ? data : nullptr;
      taken |= takes;
    } else if (entry.property == "path") {
      entry.value = lumen::Path{file.string()};
    }
  }
  if (!taken) throw lumen::Error(file.string(), exporter.type() + " writes no " + std::string(name_of(data->kind())));
  auto writing = std::make_unique<Writing>(exporter, std::move(snapshot), state_->helper, [](float) { return true; });
  writing->start();
  return std::async(std::launch::deferred, [writing = std::move(writing)] { writing->finish(); });
}

}  // namespace lumenshop
