/// The cheapest cut between the sources and the sinks of a graph. Dinic, Algorithm for solution of a problem of maximum flow in networks with
/// power estimation, Soviet Math. Dokl. 11, 1970.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

class MinimumCut {
 public:
  enum class End : std::uint8_t { neither, source, sink };

  explicit MinimumCut(std::size_t nodes) : ends_(nodes, End::neither), first_(nodes, none), level_(nodes), next_(nodes) {}
  void set_end(std::uint32_t node, End end) { ends_[node] = end; }
  /// Costs the same in either direction.
  void add_edge(std::uint32_t a, std::uint32_t b, int capacity);
  /// `step` is called now and then and may throw.
  void run(const std::function<void()>& step);
  /// Afterwards.
  bool on_source_side(std::uint32_t node) const { return level_[node] >= 0; }

 private:
  static constexpr std::uint32_t none = 0xffffffff;
  /// One direction; the opposite one has the number ^ 1.
  struct Arc {
    std::uint32_t to, next;
    int capacity;
  };

  bool find_levels();
  void push_from(std::uint32_t source);

  std::vector<Arc> arcs_;
  std::vector<End> ends_;
  std::vector<std::uint32_t> first_;   ///< arc of each node
  std::vector<int> level_;             ///< steps from a source; -1: out of reach
  std::vector<std::uint32_t> next_;    ///< arc of each node to be tried
  std::vector<std::uint32_t> queue_, path_;
};
