#include "model/link_graph.h"

#include <algorithm>
#include <unordered_set>
#include <vector>

#include <lumen/error.h>

#include "model/components.h"
#include "model/session.h"

namespace lumenshop {

using lumen::Value;
using lumen::ValueType;

namespace {

std::string named(const lumen::PropertySpec& spec) {
  if (spec.type == ValueType::data) return std::string(lumen::name_of(spec.data_kind)) + " data";
  return std::string(lumen::name_of(spec.type));
}

/// Why values of one cannot drive the other; empty if they can.
std::string misfit(const lumen::PropertySpec& source, const lumen::PropertySpec& target, bool by_expression) {
  if (target.output) return "is an output: its plugin makes it";
  const bool both_data = source.type == ValueType::data && target.type == ValueType::data;
  if (!convertible(source.type, target.type) || (both_data && source.data_kind != target.data_kind))
    return named(source) + " does not convert to " + named(target);
  if (by_expression && (components_in(source.type) == 0 || components_in(target.type) == 0))
    return "an expression needs numbers, not " + named(source);
  return {};
}

Value computed(const Value& value, const Expression& expression, const lumen::PropertySpec& target) {
  const Components components = components_of(value);
  const int count = components_in(target.type);
  std::array<double, 16> results{};
  for (int i = 0; i < count; ++i) results[i] = expression(components.values[components.count == 1 ? 0 : i], i);
  return clamped(from_components(target.type, results), target);
}

}  // namespace

std::string path_of(const Slot& slot) { return slot.owner->id() + "." + slot.spec.id; }

Slot* LinkGraph::source(Slot& slot) const {
  if (!slot.link) return nullptr;
  if (slot.followed.resolved_at == structure_) return slot.followed.source;
  slot.followed.resolved_at = structure_;
  slot.followed.source = nullptr;
  slot.followed.source_revision = 0;
  if (const Instance* instance = session_.find(slot.link->instance))
    if (const int index = instance->slot_of(slot.link->property); index >= 0) slot.followed.source = instance->slots()[index].get();
  return slot.followed.source;
}

void LinkGraph::follow_chain(Slot& first) const {
  std::vector<Slot*> chain;
  Slot* slot = &first;
  while (slot && slot->link && slot->followed.checked_at != values_ && !slot->followed.walking) {
    slot->followed.walking = true;
    chain.push_back(slot);
    slot = source(*slot);
  }
  if (slot && slot->followed.walking) {  // came back to itself: nothing in the circle has a value to give
    const auto begin = std::find(chain.begin(), chain.end(), slot);
    std::string path;
    for (auto member = begin; member != chain.end(); ++member) path += path_of(**member) + " -> ";
    path += path_of(*slot);
    for (auto member = begin; member != chain.end(); ++member) {
      (*member)->error = "links in a circle: " + path;
      (*member)->followed.checked_at = values_;
    }
  }
  // From the far end, so that each finds its source up to date.
  for (auto member = chain.rbegin(); member != chain.rend(); ++member) {
    (*member)->followed.walking = false;
    if ((*member)->followed.checked_at != values_) follow(**member);
  }
}

void LinkGraph::follow(Slot& slot) const {
  slot.followed.checked_at = values_;
  const auto take = [&](Value value) {
    if (value == slot.effective) return;
    slot.effective = std::move(value);
    ++slot.revision;
  };
  const Slot* from = source(slot);
  if (!from) {
    const Instance* instance = session_.find(slot.link->instance);
    if (!instance) slot.error = "linked to '" + slot.link->path() + "', but there is no instance '" + slot.link->instance + "'";
    else if (!instance->plugin()) slot.error = "linked to '" + slot.link->path() + "', but the plugin " + instance->type() + " is not there";
    else slot.error = "linked to '" + slot.link->path() + "', but " + instance->id() + " has no such property";
    if (slot.spec.type == ValueType::data) take(lumen::DataPointer{});  // other values keep their last
    return;
  }
  if (slot.followed.source_revision == from->revision) return;
  slot.followed.source_revision = from->revision;
  const std::string why = misfit(from->spec, slot.spec, slot.link->expression != nullptr);
  if (!why.empty()) {
    slot.error = "linked to '" + slot.link->path() + "', but " + why;
    return;
  }
  try {
    take(slot.link->expression ? computed(from->effective, *slot.link->expression, slot.spec) : convert(from->effective, slot.spec));
    slot.error.clear();
  } catch (const lumen::Error& error) {
    slot.error = error.what();
  }
}

Slot& LinkGraph::write_target(Slot& first) const {
  std::unordered_set<const Slot*> seen;
  Slot* slot = &first;
  while (slot->link) {
    if (slot->link->expression)
      throw lumen::Error(path_of(*slot), "is driven by " + slot->link->path() + " through the expression '" + slot->link->expression->text() + "'",
                         "set that, or unlink it first");
    if (!seen.insert(slot).second) throw lumen::Error(path_of(first), "is linked in a circle", "unlink it first");
    Slot* next = source(*slot);
    if (!next) throw lumen::Error(path_of(*slot), "is linked to " + slot->link->path() + ", which is not there", "unlink it first");
    slot = next;
  }
  return *slot;
}

bool LinkGraph::closes_cycle(const Slot& target, Slot& first) const {
  std::unordered_set<const Slot*> seen;
  for (Slot* slot = &first; slot && seen.insert(slot).second; slot = source(*slot))
    if (slot == &target) return true;
  return false;  // also where the chain ends in an older circle that the target is not in
}

bool LinkGraph::fits(const Slot& target, Slot& source) const {
  return misfit(source.spec, target.spec, false).empty() && !closes_cycle(target, source);
}

void LinkGraph::check(const Slot& target, Slot& source, bool by_expression) const {
  if (const std::string why = misfit(source.spec, target.spec, by_expression); !why.empty())
    throw lumen::Error(path_of(target), "cannot be linked to " + path_of(source) + ": " + why);
  if (!closes_cycle(target, source)) return;
  std::string path = path_of(target);
  for (Slot* slot = &source; slot != &target; slot = this->source(*slot)) path += " -> " + path_of(*slot);
  path += " -> " + path_of(target);
  throw lumen::Error(path_of(target), "cannot be linked to " + path_of(source) + ", it would drive itself: " + path);
}

Value converted_back(const Value& value, const Slot& source) {
  const ValueType from = lumen::type_of(value), to = source.spec.type;
  if (convertible(from, to)) return convert(value, source.spec);
  const Components components = components_of(value);
  const auto all = components.view();
  const bool one_number = !all.empty() && std::all_of(all.begin(), all.end(), [&](double number) { return number == all[0]; });
  if (components_in(to) != 1 || !one_number)
    throw lumen::Error(path_of(source), std::string(lumen::name_of(from)) + " does not convert back to " + std::string(lumen::name_of(to)),
                       "set the source itself, or unlink first");
  return clamped(from_components(to, all), source.spec);
}

}  // namespace lumenshop
