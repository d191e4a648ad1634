#include "measurement.h"

#include <algorithm>

Measurement::Measurement(std::string view, std::string surface, std::string splitter)
    : surface(std::move(surface)), splitter(std::move(splitter)), view_(std::move(view)) {}

bool Measurement::step(lumen::Workbench& workbench) {
  if (drawn_ == 2 * frames) return false;
  const int which = drawn_ / frames;
  // A frame of its own each time: what was drawn is not drawn again.
  if (trial_ == nullptr) trial_ = workbench.trial(view_, which == 0 ? surface : splitter, {});
  trial_->step();
  if (drawn_ % frames > 0) samples_[which].push_back(trial_->milliseconds());
  trial_.reset();
  ++drawn_;
  return drawn_ < 2 * frames;
}

double Measurement::median(std::vector<double> samples) {
  if (samples.empty()) return 0;
  std::sort(samples.begin(), samples.end());
  return samples[samples.size() / 2];
}
