// Once per frame: links are brought up to date, objects hear what changed.
#include <set>

#include "model/session.h"

namespace lumenshop {

namespace {
constexpr int most_rounds = 16;
}

/// Something that an object is to hear. By id, not by pointer: an earlier notice's receiver may have changed the session.
struct Session::Notice {
  std::string instance;
  const lumen::Plugin* object;
  std::string property;      ///< its own, or a watched "other.radius"
  bool released = false;     ///< `enabled` went off
};

std::vector<Session::Notice> Session::pending_notices() {
  std::vector<Notice> notices;
  for (const auto* list : {&contents_.plugins, &contents_.views})
    for (const auto& instance : *list) {
      if (!instance->plugin_) continue;
      PropertyTable& table = *instance->table_;
      for (const auto& slot : table.slots()) {
        if (slot->retracted) continue;
        graph_.refresh(*slot);
        if (slot->notified == slot->revision) continue;
        slot->notified = slot->revision;
        notices.push_back({instance->id(), instance->plugin(), slot->spec.id});
      }
      for (auto& [path, watch] : table.watches()) {
        const std::uint64_t revision = revision_of(path);
        if (watch.seen == revision) continue;
        watch.seen = revision;
        notices.push_back({instance->id(), instance->plugin(), path});
      }
      const bool enabled = instance->enabled();
      if (std::exchange(instance->was_enabled_, enabled) && !enabled) notices.push_back({instance->id(), instance->plugin(), "enabled", true});
    }
  return notices;
}

void Session::deliver(const Notice& notice) {
  Instance* instance = find(notice.instance);
  if (!instance || instance->plugin() != notice.object) return;
  const std::shared_ptr<lumen::Plugin> object = instance->share();
  std::string failure;
  try {
    notice.released ? object->released() : object->changed(notice.property);
  } catch (const std::exception& error) {
    failure = error.what();
  } catch (...) {
    failure = "it threw something that is no std::exception";
  }
  auto& failures = instance->change_failures_;
  const auto known = failures.find(notice.property);
  if (failure.empty() ? known == failures.end() : known != failures.end() && known->second == failure) return;
  if (failure.empty()) failures.erase(known);
  else failures[notice.property] = failure;
  something_changed();
}

void Session::update() {
  if (graph_.values() == updated_) return;
  ++quiet_;  // what objects derive from an edit is part of it: undoing the edit derives it again
  std::string restless;
  for (int round = 0; graph_.values() != updated_; ++round) {
    updated_ = graph_.values();
    const std::vector<Notice> notices = pending_notices();
    if (round == most_rounds) {
      std::set<std::string> paths;
      for (const Notice& notice : notices)
        paths.insert(notice.property.find('.') == std::string::npos ? notice.instance + "." + notice.property : notice.property);
      for (const std::string& path : paths) restless += (restless.empty() ? "" : ", ") + path;
      break;
    }
    for (const Notice& notice : notices) deliver(notice);
  }
  --quiet_;
  if (restless_ == restless) return;
  restless_ = std::move(restless);
  something_changed();
}

}  // namespace lumenshop
