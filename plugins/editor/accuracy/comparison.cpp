#include "comparison.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>

#include <lumen/error.h>

namespace {

/// What is compared, and the layer that tells which pixels count.
struct Layers {
  const char *compared, *covering;
};

Layers layers_of(lumen::Kind kind) { return kind == lumen::Kind::occlusion ? Layers{"occlusion", "depth"} : Layers{"color", "opacity"}; }

}  // namespace

Comparison::Comparison(std::string view, lumen::Kind kind, lumen::InstanceState reference, std::vector<lumen::InstanceState> candidates)
    : view_(std::move(view)), kind_(kind) {
  std::erase_if(candidates, [&](const lumen::InstanceState& state) { return state.id == reference.id; });
  waiting_.push_back(std::move(reference));
  waiting_.insert(waiting_.end(), std::make_move_iterator(candidates.begin()), std::make_move_iterator(candidates.end()));
  count_ = waiting_.size();
}

float Comparison::progress() const {
  return count_ == 0 ? 1 : (float(count_ - waiting_.size()) + (trial_ == nullptr ? 0 : trial_->progress())) / float(count_);
}

std::string Comparison::current() const { return waiting_.empty() ? std::string() : waiting_.front().id; }

bool Comparison::step(lumen::Workbench& workbench, double seconds) {
  const auto begun = std::chrono::steady_clock::now();
  while (!waiting_.empty()) {
    try {
      if (trial_ == nullptr) begin(workbench);
      if (!trial_->step()) finish();
    } catch (const std::exception& error) {
      rows_.push_back({.instance = waiting_.front().id, .type = waiting_.front().type, .failure = error.what()});
      trial_.reset();
      waiting_.erase(waiting_.begin());
      if (rows_.size() == 1) waiting_.clear();  // nothing to compare with
    }
    if (std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count() >= seconds) break;
  }
  return !waiting_.empty();
}

void Comparison::begin(lumen::Workbench& workbench) {
  const Layers layers = layers_of(kind_);
  trial_ = workbench.trial(view_, waiting_.front().id, {layers.compared, layers.covering});
}

void Comparison::finish() {
  const Layers layers = layers_of(kind_);
  Row row{.instance = waiting_.front().id, .type = waiting_.front().type};
  row.picture = trial_->layer(layers.compared);
  row.milliseconds = trial_->milliseconds();
  row.bytes = trial_->bytes();
  if (rows_.empty()) {
    const auto covering = trial_->layer(layers.covering);
    width_ = covering->width;
    height_ = covering->height;
    counts_.resize(covering->pixels.size());
    for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] = std::isfinite(covering->pixels[i]) && covering->pixels[i] > 0;
  }
  const lumen::Image& reference = rows_.empty() ? *row.picture : *rows_.front().picture;
  if (row.picture->pixels.size() != reference.pixels.size()) throw lumen::Error(row.instance, "the view's size changed meanwhile");
  row.difference = difference(*row.picture, reference, counts_);
  rows_.push_back(std::move(row));
  trial_.reset();
  waiting_.erase(waiting_.begin());
}

void Comparison::write_csv(const std::string& file) const {
  std::ofstream stream(file);
  stream.imbue(std::locale::classic());
  stream << "instance,type,rmse,largest,structural,milliseconds,bytes\n";
  for (const Row& row : rows_)
    if (row.failure.empty())
      stream << row.instance << ',' << row.type << ',' << row.difference.rmse << ',' << row.difference.largest << ',' << row.difference.structural << ','
             << row.milliseconds << ',' << row.bytes << '\n';
  stream.close();
  if (!stream) throw lumen::Error(file, "could not be written", "choose a file in a folder that exists and is yours");
}
