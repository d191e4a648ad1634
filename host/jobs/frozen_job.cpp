/// Freezing values, checking results, and turning exceptions into messages.
#include "jobs/frozen_job.h"

#include <new>

#include <lumen/image.h>
#include <lumen/lines.h>
#include <lumen/mesh.h>
#include <lumen/volume.h>

#include "process/helper.h"

namespace lumenshop {

namespace {

/// A shallow copy (arrays are shared) that has passed its own checks: a plugin's data is believed only then.
template <class T> lumen::DataPointer checked_copy(const lumen::Data& data, const std::string& origin) {
  auto copy = std::make_shared<T>(dynamic_cast<const T&>(data));
  if (copy->origin.empty()) copy->origin = origin;
  copy->finish();
  return copy;
}

lumen::DataPointer checked(const lumen::Data& data, const std::string& origin) {
  switch (data.kind()) {
    case lumen::DataKind::mesh: return checked_copy<lumen::Mesh>(data, origin);
    case lumen::DataKind::lines: return checked_copy<lumen::Lines>(data, origin);
    case lumen::DataKind::volume: return checked_copy<lumen::Volume>(data, origin);
    case lumen::DataKind::image: return checked_copy<lumen::Image>(data, origin);
  }
  return nullptr;
}

}  // namespace

Snapshot Snapshot::of(const Instance& instance) {
  Snapshot snapshot{instance.id(), {}};
  for (std::size_t slot = 0; slot < instance.slots().size(); ++slot) {
    const Slot& source = *instance.slots()[slot];
    // A retracted slot has no object that could ask for it.
    snapshot.slots.push_back({source.retracted ? source.spec.default_value : instance.read(static_cast<int>(slot)),
                              source.spec.type == lumen::ValueType::data && source.spec.output, source.spec.data_kind, source.spec.id});
  }
  return snapshot;
}

FrozenJob::FrozenJob(Snapshot snapshot, Helper* helper, std::function<bool(float)> proceed)
    : snapshot_(std::move(snapshot)), helper_(helper), proceed_(std::move(proceed)), results_(snapshot_.slots.size()) {}

void FrozenJob::progress(float fraction) {
  if (!proceed_(fraction)) throw lumen::Cancelled{};
}

void FrozenJob::report(lumen::Severity severity, const std::string& message) {
  constexpr std::size_t most = 100;  // a line per broken cell helps nobody
  if (reports_.size() < most) reports_.push_back({severity, message});
}

lumen::WorkerReply FrozenJob::run(const lumen::WorkerRequest& request) {
  if (!helper_) throw lumen::Error(request.module, "there is no helper process to run it");
  lumen::WorkerReply reply = helper_->run(request, proceed_);
  for (const auto& note : reply.notes) report(note.severity, note.text);
  return reply;
}

void FrozenJob::write(int slot, lumen::DataPointer data) {
  const auto index = static_cast<std::size_t>(slot);
  if (slot < 0 || index >= snapshot_.slots.size() || !snapshot_.slots[index].output)
    throw lumen::Error(snapshot_.instance, "its code wrote to slot " + std::to_string(slot) + ", which is no output");
  const Snapshot::Entry& entry = snapshot_.slots[index];
  const std::string path = snapshot_.instance + "." + entry.property;
  if (data && data->kind() != entry.data_kind)
    throw lumen::Error(path, "its code made a " + std::string(name_of(data->kind())) + " for an output of type " + std::string(name_of(entry.data_kind)));
  results_[index] = data ? checked(*data, path) : nullptr;
}

const lumen::Value& FrozenJob::read(int slot) const { return snapshot_.slots.at(static_cast<std::size_t>(slot)).value; }

Outcome Outcome::of(const std::function<void()>& work) {
  try {
    work();
    return {};
  } catch (const lumen::Cancelled&) {
    return {State::cancelled, {}};
  } catch (const std::bad_alloc&) {
    return {State::failed, "ran out of memory; ask for less, or close other data"};
  } catch (const std::exception& error) {
    return {State::failed, error.what()};
  } catch (...) {
    return {State::failed, "its code threw something that is no std::exception"};
  }
}

}  // namespace lumenshop
