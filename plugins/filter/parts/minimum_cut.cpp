#include "minimum_cut.h"

#include <algorithm>
#include <limits>

void MinimumCut::add_edge(std::uint32_t a, std::uint32_t b, int capacity) {
  arcs_.push_back({b, first_[a], capacity});
  first_[a] = std::uint32_t(arcs_.size() - 1);
  arcs_.push_back({a, first_[b], capacity});
  first_[b] = std::uint32_t(arcs_.size() - 1);
}

void MinimumCut::run(const std::function<void()>& step) {
  while (find_levels()) {
    step();
    next_ = first_;
    for (std::uint32_t node = 0; node < ends_.size(); ++node)
      if (ends_[node] == End::source) push_from(node);
  }
}

/// False if no sink is in reach: then the levels tell the sides.
bool MinimumCut::find_levels() {
  std::fill(level_.begin(), level_.end(), -1);
  queue_.clear();
  for (std::uint32_t node = 0; node < ends_.size(); ++node)
    if (ends_[node] == End::source) level_[node] = 0, queue_.push_back(node);
  bool reached = false;
  for (std::size_t at = 0; at < queue_.size(); ++at) {
    const std::uint32_t node = queue_[at];
    if (ends_[node] == End::sink) {
      reached = true;
      continue;
    }
    for (std::uint32_t arc = first_[node]; arc != none; arc = arcs_[arc].next)
      if (arcs_[arc].capacity > 0 && level_[arcs_[arc].to] < 0) level_[arcs_[arc].to] = level_[node] + 1, queue_.push_back(arcs_[arc].to);
  }
  return reached;
}

/// All that flows from a source along shortest ways.
void MinimumCut::push_from(std::uint32_t source) {
  std::uint32_t node = source;
  path_.clear();
  while (true) {
    if (ends_[node] == End::sink) {
      int flow = std::numeric_limits<int>::max();
      for (const std::uint32_t arc : path_) flow = std::min(flow, arcs_[arc].capacity);
      std::size_t kept = path_.size();
      for (std::size_t i = path_.size(); i-- > 0;) {
        arcs_[path_[i]].capacity -= flow;
        arcs_[path_[i] ^ 1].capacity += flow;
        if (arcs_[path_[i]].capacity == 0) kept = i;
      }
      node = arcs_[path_[kept] ^ 1].to;
      path_.resize(kept);
      continue;
    }
    std::uint32_t& arc = next_[node];
    while (arc != none && (arcs_[arc].capacity == 0 || level_[arcs_[arc].to] != level_[node] + 1)) arc = arcs_[arc].next;
    if (arc != none) {
      path_.push_back(arc);
      node = arcs_[arc].to;
    } else if (path_.empty()) {
      return;
    } else {
      node = arcs_[path_.back() ^ 1].to;
      path_.pop_back();
      next_[node] = arcs_[next_[node]].next;
    }
  }
}
