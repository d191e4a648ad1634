// Edits of properties: values, links, resets; what an undo step holds.
#include <lumen/interactor.h>

#include "model/components.h"
#include "model/json_text.h"
#include "model/session.h"
#include "model/session_path.h"

namespace lumenshop {

using lumen::Value;
using lumen::ValueType;

void Session::edit(Slot& slot, bool by_object, const std::function<void(PropertyTable&)>& change) {
  const std::shared_ptr<PropertyTable> table = slot.owner->table_;
  const Json before = table->json(slot, folder());
  change(*table);
  const Json after = table->json(slot, folder());
  if (before == after) return;
  ++document_revision_;
  if (quiet_ > 0) return;
  const auto* interactor = slot.owner->as<lumen::Interactor>(lumen::Kind::interactor);
  history_.record({.instance = slot.owner->id(), .property = slot.spec.id, .before = before, .after = after, .folder = folder()}, by_object,
                  by_object && interactor && interactor->is_camera());
}

void Session::write(Slot& slot, Value value, bool by_object) {
  if (slot.spec.type == ValueType::data)
    throw lumen::Error(path_of(slot), slot.spec.output ? "is an output: its plugin makes it" : "data comes in by a link only");
  if (lumen::type_of(value) != slot.spec.type) {
    if (!convertible(lumen::type_of(value), slot.spec.type))
      throw lumen::Error(path_of(slot), "is " + std::string(lumen::name_of(slot.spec.type)) + ", not " + std::string(lumen::name_of(lumen::type_of(value))));
    value = convert(value, slot.spec);
  }
  if (!is_finite(value)) throw lumen::Error(path_of(slot), "the value is not finite");
  Slot& target = graph_.write_target(slot);
  if (&target != &slot) value = converted_back(value, target);
  bool relative = false;
  if (auto* path = std::get_if<lumen::Path>(&value)) relative = make_absolute(*path, folder());
  value = clamped(std::move(value), target.spec);
  if (target.set && target.own == value && target.relative == relative) return;
  edit(target, by_object, [&](PropertyTable& table) { table.assign(target, std::move(value), relative); });
}

void Session::set(const std::string& path, Value value) { write(slot_at(path), std::move(value), false); }

void Session::set(const std::string& path, const Json& json) {
  Slot& slot = slot_at(path);
  if (!json.is_object() || !json.contains("link")) {
    try {
      return write(slot, from_json(json, slot.spec), false);
    } catch (const lumen::Error& error) {  // from_json knows the property's name alone
      const std::string what = error.what();
      throw what.rfind(slot.spec.id + ":", 0) == 0 ? lumen::Error(slot.owner->id() + "." + what) : error;
    }
  }
  const Json expression = json.value("expression", Json(""));
  if (!json["link"].is_string() || !expression.is_string()) throw lumen::Error(path, "a link is {\"link\": \"instance.property\"}");
  link(slot, json["link"].get<std::string>(), expression.get<std::string>(), false);
}

void Session::reset(const std::string& path) {
  const auto dot = path.find('.');
  Instance* instance = find(path.substr(0, dot));
  if (instance && dot != std::string::npos)
    if (const auto kept = instance->orphans().find(path.substr(dot + 1)); kept != instance->orphans().end()) {
      Change change{.instance = instance->id(), .property = path.substr(dot + 1), .before = *kept, .after = nullptr, .folder = folder()};
      instance->table_->restore(change.property, nullptr, folder());
      return record(std::move(change));
    }
  Slot& slot = slot_at(path);
  edit(slot, false, [&](PropertyTable& table) { table.clear(slot); });
}

void Session::link(const std::string& path, const std::string& source, const std::string& expression) {
  link(slot_at(path), source, expression, false);
}

void Session::link(Slot& slot, const std::string& source, const std::string& expression, bool by_object) {
  const auto [instance, index] = resolve(source);
  Slot& from = *instance->slots()[index];
  graph_.check(slot, from, !expression.empty());
  Link link{instance->id(), from.spec.id, expression.empty() ? nullptr : std::make_unique<Expression>(expression)};
  edit(slot, by_object, [&](PropertyTable& table) { table.connect(slot, std::move(link)); });
}

void Session::unlink(const std::string& path) { unlink(slot_at(path), false); }

void Session::unlink(Slot& slot, bool by_object) {
  if (!slot.link) return;
  edit(slot, by_object, [&](PropertyTable& table) { table.disconnect(slot); });
}

std::vector<std::string> Session::linkable(const std::string& path) const {
  Slot& target = slot_at(path);
  std::vector<std::string> result;
  for (const auto* list : {&contents_.views, &contents_.plugins})
    for (const auto& instance : *list)
      for (const auto& slot : instance->slots())
        if (!slot->retracted && slot.get() != &target && graph_.fits(target, *slot)) result.push_back(path_of(*slot));
  return result;
}

void Session::override_value(const std::string& path, const std::string& json_or_text) {
  Slot& slot = slot_at(path);
  Json json = json_or_text;
  const bool is_text = slot.spec.type == ValueType::string || slot.spec.type == ValueType::path || slot.spec.type == ValueType::choice ||
                       slot.spec.type == ValueType::reference;
  try {
    json = parse_json(json_or_text, path);
    if (is_text && !json.is_string() && !json.is_object()) json = json_or_text;  // a title of "2024" is no number
  } catch (const lumen::Error&) {
    // Not JSON: the text itself is meant.
  }
  const struct Quiet {
    int& count;
    explicit Quiet(int& count) : count(count) { ++count; }
    ~Quiet() { --count; }
  } quiet(quiet_);
  if (slot.spec.type == ValueType::path && json.is_string()) {
    lumen::Path file{json.get<std::string>()};
    make_absolute(file, std::filesystem::current_path());
    json = file.file;
  }
  set(path, json);
}

}  // namespace lumenshop
