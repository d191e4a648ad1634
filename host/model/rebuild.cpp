// Objects of a newer generation take the place of older ones, and give it back if they are not fit.
#include <algorithm>

#include "model/session.h"

namespace lumenshop {

struct Rebuild::State {
  struct Entry {
    Instance* instance;
    std::string id;
    Instance::Object other;  ///< before swap() the new object, after it the old one
  };
  Session& session;
  std::vector<Entry> entries;
  bool swapped = false;

  /// The instances that are still in the session: one may have been removed meanwhile.
  template <class Function>
  void each(Function function) {
    for (Entry& entry : entries)
      if (std::any_of(session.contents_.plugins.begin(), session.contents_.plugins.end(),
                      [&](const auto& instance) { return instance.get() == entry.instance; }))
        function(entry);
  }
};

Rebuild::Rebuild(Session& session, PluginFactory& factory, const std::vector<std::string>& types)
    : state_(std::make_unique<State>(State{session, {}, false})) {
  try {
    for (const auto& instance : session.contents_.plugins)
      if (std::find(types.begin(), types.end(), instance->type()) != types.end())
        state_->entries.push_back({instance.get(), instance->id(), instance->build(factory, instance->orphans(), instance->table_.get())});
  } catch (...) {
    for (State::Entry& entry : state_->entries) entry.other.table->close();
    throw;
  }
}

Rebuild::~Rebuild() {
  if (state_) revert();
}

void Rebuild::swap() {
  if (!state_ || state_->swapped) return;
  state_->swapped = true;
  state_->each([](State::Entry& entry) { entry.instance->exchange(entry.other); });
}

void Rebuild::keep() {
  if (!state_) return;
  swap();
  for (State::Entry& entry : state_->entries) entry.other.table->close();
  state_.reset();
}

void Rebuild::revert() {
  if (!state_) return;
  if (state_->swapped)
    state_->each([](State::Entry& entry) {
      entry.instance->exchange(entry.other);
      // Who has seen a value of the failed object must not take an old revision for it.
      for (const auto& slot : entry.instance->slots())
        if (const int failed = entry.other.table->slot_of(slot->spec.id); failed >= 0) {
          const Slot& seen = *entry.other.table->slots()[failed];
          const bool told = slot->notified == slot->revision;
          if (seen.revision != slot->revision || seen.effective != slot->effective) slot->revision = std::max(slot->revision, seen.revision) + 1;
          if (told) slot->notified = slot->revision;
        }
    });
  for (State::Entry& entry : state_->entries) entry.other.table->close();
  state_.reset();
}

}  // namespace lumenshop
