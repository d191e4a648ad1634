#include "window/view_trial.h"

#include <algorithm>
#include <numeric>

#include <lumen/error.h>

namespace lumenshop {

ViewTrial::ViewTrial(Workshop& workshop, const std::string& view, const std::string& instance, const std::vector<std::string>& layers)
    : workshop_(workshop), instance_(instance), renderer_(workshop.session(), workshop.shaders(), view) {
  const Instance* technique = workshop.session().find(instance);
  if (technique == nullptr || technique->plugin() == nullptr) throw lumen::Error(instance, "there is no such instance");
  is_technique_ = technique->kind() == lumen::Kind::occlusion || technique->kind() == lumen::Kind::transparency;
  if (!is_technique_ && technique->kind() != lumen::Kind::splitter && technique->kind() != lumen::Kind::renderer)
    throw lumen::Error(instance, "is no occlusion, transparency, splitter or renderer: there is nothing to compare");
  renderer_.substitute(instance);
  renderer_.resize(workshop.view(view).size());
  renderer_.request(layers);
  renderer_.set_timing(true);
}

bool ViewTrial::step() {
  renderer_.draw();
  return renderer_.unfinished();
}

double ViewTrial::milliseconds() const {
  double sum = 0;
  for (const PassStatistics& pass : renderer_.statistics())
    if (!is_technique_ || pass.name == instance_ || pass.name.ends_with("/" + instance_)) sum = std::accumulate(pass.samples.begin(), pass.samples.end(), sum);
  return sum;
}

std::size_t ViewTrial::bytes() const {
  const Instance* technique = workshop_.session().find(instance_);
  return technique == nullptr ? 0 : renderer_.bytes_of(*technique);
}

}  // namespace lumenshop
