/// compute() with its progress and its end.
#include "jobs/run.h"

#include <algorithm>

namespace lumenshop {

Run::Run(std::shared_ptr<lumen::Plugin> object, Snapshot snapshot, std::string title, Helper* helper)
    : object_(std::move(object)), title_(std::move(title)), job_(std::move(snapshot), helper, [this](float fraction) {
        fraction_ = std::clamp(fraction, 0.0f, 1.0f);
        return !cancelled_;
      }) {}

void Run::compute() {
  const auto& source = static_cast<const lumen::Source&>(*object_);
  outcome_ = Outcome::of([&] {
    job_.progress(0);
    source.compute(job_);
  });
  // What finished in spite of being cancelled is out of date all the same.
  if (cancelled_) outcome_ = {Outcome::State::cancelled, {}};
}

double Run::seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }

}  // namespace lumenshop
