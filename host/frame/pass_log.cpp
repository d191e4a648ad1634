#include "frame/pass_log.h"

#include <algorithm>

namespace lumenshop {

void PassLog::finish(const std::string& name, double milliseconds) {
  auto found = std::find_if(statistics_.begin(), statistics_.end(), [&](const PassStatistics& pass) { return pass.name == name; });
  if (found == statistics_.end()) found = statistics_.insert(statistics_.end(), PassStatistics{.name = name});
  ++found->runs;
  ++total_runs_;
  found->milliseconds = milliseconds;
  if (timing_) found->samples.push_back(milliseconds);
}

std::vector<PassStatistics> PassLog::statistics() const { return statistics_; }

void PassLog::reset() {
  for (PassStatistics& pass : statistics_) {
    pass.runs = 0;
    pass.samples.clear();
  }
}

}  // namespace lumenshop
