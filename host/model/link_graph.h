/// How values flow through links: each slot has at most one source, so what drives it is a chain.
///
/// Lazy: a linked slot compares one number (values()) when it is read, and follows its chain only when something in the
/// session has changed since. Chains are walked in a loop: a session with a hundred thousand links costs no stack.
/// Thread: main.
#pragma once

#include <cstdint>
#include <string>

#include "model/slot.h"

namespace lumenshop {

class Session;

std::string path_of(const Slot& slot);  ///< "instance.property"

class LinkGraph {
 public:
  explicit LinkGraph(const Session& session) : session_(session) {}

  std::uint64_t values() const { return values_; }        ///< grows when a value, a link or the structure changes
  std::uint64_t structure() const { return structure_; }  ///< grows when slots come or go, or a link changes
  void value_changed() { ++values_; }
  void structure_changed() { ++structure_, ++values_; }

  /// `effective`, `revision` and `error` of a linked slot are up to date after it.
  void refresh(Slot& slot) const {
    if (slot.link && slot.followed.checked_at != values_ && !paused_) follow_chain(slot);
  }
  /// While a file's instances are made one by one no link is followed: what a constructor reads does not depend on their
  /// order, and chains are not walked again for each.
  void pause(bool on) { paused_ = on; }
  /// What drives the slot; null if there is no link, or its source is not there.
  Slot* source(Slot& slot) const;
  /// The slot that a write to this one sets, at the end of identity links. Throws lumen::Error naming both.
  Slot& write_target(Slot& slot) const;
  /// Throws lumen::Error if `source` cannot drive `target`: not convertible, another kind of data, an output, a cycle ("a.x -> b.y -> a.x").
  void check(const Slot& target, Slot& source, bool by_expression) const;
  /// The same as a question: for lists of what can be linked.
  bool fits(const Slot& target, Slot& source) const;

 private:
  const Session& session_;
  std::uint64_t values_ = 1, structure_ = 1;
  bool paused_ = false;

  bool closes_cycle(const Slot& target, Slot& source) const;
  void follow_chain(Slot& slot) const;
  void follow(Slot& slot) const;
};

/// What writing `value` through an identity link gives its source: the inverse of convert(). Throws lumen::Error.
lumen::Value converted_back(const lumen::Value& value, const Slot& source);

}  // namespace lumenshop
