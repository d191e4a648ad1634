/// Who is due, what it waits for, and the adoption of what its job made.
#include "jobs/scheduler_state.h"

#include <algorithm>
#include <thread>

namespace lumenshop {

namespace {

const lumen::Source* source_of(const Instance& instance) {
  if (const auto* importer = instance.as<lumen::Source>(lumen::Kind::importer)) return importer;
  return instance.as<lumen::Source>(lumen::Kind::filter);
}

bool is_output(const Slot& slot) { return slot.spec.type == lumen::ValueType::data && slot.spec.output && !slot.retracted; }
bool is_input(const Slot& slot) { return slot.spec.type == lumen::ValueType::data && !slot.spec.output && !slot.retracted; }

Key key_of(const Instance& instance) {
  Key key;
  for (std::size_t slot = 0; slot < instance.slots().size(); ++slot) {
    const Slot& held = *instance.slots()[slot];
    const bool counts = !held.retracted && !is_output(held) && held.spec.options.affects == lumen::Affects::draw && held.spec.id != "enabled";
    key.push_back(counts ? instance.revision(static_cast<int>(slot)) : 0);
  }
  return key;
}

/// "scan: reading aorta.vtp", "smooth: computing".
std::string title_of(const Instance& instance) {
  for (std::size_t slot = 0; slot < instance.slots().size(); ++slot) {
    const auto* path = std::get_if<lumen::Path>(&instance.read(static_cast<int>(slot)));
    if (path && !path->file.empty() && instance.kind() == lumen::Kind::importer)
      return instance.id() + ": reading " + std::filesystem::path(path->file).filename().string();
  }
  return instance.id() + ": computing";
}

/// Gives every output the state; its data stays.
void set_state(Instance& instance, const std::string& state) {
  for (std::size_t slot = 0; slot < instance.slots().size(); ++slot) {
    const Slot& held = *instance.slots()[slot];
    if (is_output(held) && held.data_state != state)
      instance.adopt(static_cast<int>(slot), std::get<lumen::DataPointer>(instance.read(static_cast<int>(slot))), state);
  }
}

}  // namespace

Scheduler::State::State(Session& session, Helper* helper, std::function<void()> wake)
    : session(session), helper(helper), pool(static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 2u)), std::move(wake)) {}

Instance* Scheduler::State::find(const std::shared_ptr<lumen::Plugin>& object) const {
  for (const auto& instance : session.plugins())
    if (instance->share() == object) return instance.get();
  return nullptr;
}

bool Scheduler::State::any_running() const {
  return std::any_of(records.begin(), records.end(), [](const auto& entry) { return entry.second.run != nullptr; });
}

/// Follows each link to the output that it ends at.
Inputs Scheduler::State::inputs_of(const Instance& instance, std::vector<const Instance*> path) const {
  path.push_back(&instance);
  for (const auto& slot : instance.slots()) {
    if (!is_input(*slot)) continue;
    const Slot* reached = slot.get();
    constexpr int longest_chain = 64;
    for (int step = 0; reached && reached->link && step < longest_chain; ++step) {
      const Link& link = *reached->link;
      const Instance* owner = session.find(link.instance);
      const int index = owner && owner->plugin() ? owner->slot_of(link.property) : -1;
      if (index < 0) return {Inputs::State::blocked, "waits for " + link.path() + ", which is not there"};
      reached = owner->slots()[static_cast<std::size_t>(index)].get();
      if (!is_output(*reached)) continue;
      if (Inputs inputs = output_of(*owner, link.property, path); inputs.state != Inputs::State::ready) return inputs;
      break;
    }
  }
  return {};
}

Inputs Scheduler::State::output_of(const Instance& source, const std::string& property, const std::vector<const Instance*>& path) const {
  const std::string name = source.id() + "." + property;
  if (std::find(path.begin(), path.end(), &source) != path.end())
    return {Inputs::State::blocked, "waits for " + name + ", which waits for this"};
  const auto record = records.find(source.share());
  if (record != records.end() && record->second.run) return {Inputs::State::busy, {}};
  const bool due = source_of(source) && (record == records.end() || record->second.started != key_of(source));
  if (due && source.enabled()) {
    const Inputs inputs = inputs_of(source, path);
    if (inputs.state == Inputs::State::blocked) return {Inputs::State::blocked, "waits for " + name + ", which " + inputs.why};
    return {Inputs::State::busy, {}};
  }
  const std::string& state = source.slots()[static_cast<std::size_t>(source.slot_of(property))]->data_state;
  if (state == "ready") return {};
  if (!source.enabled()) return {Inputs::State::blocked, "waits for " + name + ", which is off"};
  return {Inputs::State::blocked, "waits for " + name + ", which failed"};
}

bool Scheduler::State::adopt(const std::shared_ptr<Run>& run) {
  const auto entry = records.find(run->object());
  if (entry == records.end() || entry->second.run != run) return false;
  Record& record = entry->second;
  record.run.reset();
  record.failure.clear();
  Instance* instance = find(run->object());
  if (!instance) return false;

  const Outcome& outcome = run->outcome();
  if (outcome.state == Outcome::State::cancelled) {
    if (record.stopped) record.failure = "cancelled";
    else record.started.reset();
    return false;
  }
  for (const auto& report : run->job().reports()) instance->report(report.severity, report.message);
  if (outcome.state == Outcome::State::failed) {
    instance->report(lumen::Severity::error, outcome.message);
    record.failure = outcome.message;
    return false;
  }
  const Snapshot& snapshot = run->job().snapshot();
  for (std::size_t slot = 0; slot < snapshot.slots.size(); ++slot)
    if (snapshot.slots[slot].output && is_output(*instance->slots()[slot])) instance->adopt(static_cast<int>(slot), run->job().result(slot), "ready");
  return true;
}

void Scheduler::State::consider(Instance& instance) {
  if (!source_of(instance)) return;
  Record& record = records[instance.share()];
  if (!instance.enabled()) {
    if (record.run) record.run->cancel();
    return;
  }
  Key key = key_of(instance);
  if (record.run) {
    // Its successor starts when it has ended: at most one job per instance, however fast the requests come.
    if (record.started != key) {
      record.run->cancel();
      record.stopped = false;
    }
    return;
  }
  const Inputs inputs = inputs_of(instance);
  if (inputs.state == Inputs::State::blocked) return set_state(instance, inputs.why);
  if (inputs.state == Inputs::State::busy) return set_state(instance, "pending");
  if (record.started == key) return set_state(instance, record.failure.empty() ? "ready" : record.failure);

  set_state(instance, "pending");
  instance.clear_reports();
  record.started = std::move(key);
  record.failure.clear();
  record.stopped = false;
  record.run = std::make_shared<Run>(instance.share(), Snapshot::of(instance), title_of(instance), helper);
  pool.start(record.run);
}

}  // namespace lumenshop
