// What panels see: the state of a property, and all problems.
#include <algorithm>

#include <lumen/interactor.h>

#include "model/components.h"
#include "model/session.h"

namespace lumenshop {

using lumen::Value;
using lumen::ValueType;

namespace {

constexpr std::size_t most_problems = 1000;
constexpr int longest_data_chain = 1000;

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(' ');
  return first == std::string_view::npos ? std::string() : std::string(text.substr(first, text.find_last_not_of(' ') - first + 1));
}

/// A value as conditions name it: "off", "3", "sorted", "none".
std::string name_of_value(const Value& value) {
  const auto or_none = [](const std::string& text) { return text.empty() ? std::string("none") : text; };
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "on" : "off";
  if (const auto* choice = std::get_if<lumen::Choice>(&value)) return choice->name;
  if (const auto* reference = std::get_if<lumen::Reference>(&value)) return or_none(reference->id);
  if (const auto* references = std::get_if<lumen::References>(&value)) return references->ids.empty() ? "none" : "set";
  if (const auto* text = std::get_if<std::string>(&value)) return or_none(*text);
  if (const auto* path = std::get_if<lumen::Path>(&value)) return or_none(path->file);
  if (const auto* data = std::get_if<lumen::DataPointer>(&value)) return *data ? "set" : "none";
  return to_json(value).dump();
}

bool holds(const Value& value, std::string_view operation, const std::string& wanted) {
  const std::string name = name_of_value(value);
  if (operation.empty()) return name != "off" && name != "none" && name != "0" && name != "[]";
  const bool same_flag = std::holds_alternative<bool>(value) && wanted == (name == "on" ? "true" : "false");
  const bool equal = name == wanted || same_flag;
  return operation == "=" ? equal : !equal;
}

bool is_light(const Instance& instance) {
  const auto* interactor = instance.as<lumen::Interactor>(lumen::Kind::interactor);
  return interactor ? interactor->is_light() : instance.kind() == lumen::Kind::interactor;
}

bool is_camera(const Instance& instance) {
  const auto* interactor = instance.as<lumen::Interactor>(lumen::Kind::interactor);
  return interactor ? interactor->is_camera() : instance.kind() == lumen::Kind::interactor;
}

}  // namespace

std::string Session::reference_error(const Slot& slot) const {
  std::vector<std::string> ids;
  if (const auto* reference = std::get_if<lumen::Reference>(&slot.effective)) {
    if (!reference->empty()) ids.push_back(reference->id);
  } else if (const auto* references = std::get_if<lumen::References>(&slot.effective)) {
    ids = references->ids;
  }
  const std::string& accepts = slot.spec.options.accepts;
  for (const std::string& id : ids) {
    const Instance* instance = find(id);
    if (!instance) return "there is no instance '" + id.substr(0, 80) + "'";
    const bool fits = accepts.empty() || (accepts == "camera" ? is_camera(*instance) : accepts == "light" ? is_light(*instance) : lumen::name_of(instance->kind()) == accepts);
    if (!fits) return "'" + id + "' (" + instance->type() + ") is no " + accepts;
  }
  return {};
}

std::string Session::error_of(const Slot& slot) const { return slot.error.empty() ? reference_error(slot) : slot.error; }

std::string Session::no_effect(const Instance& instance, const Slot& slot) const {
  const std::string& condition = slot.spec.options.when;
  if (condition.empty()) return {};
  const auto sign = condition.find_first_of("!=");
  const bool differs = sign != std::string::npos && condition[sign] == '!';
  const std::string property = trimmed(std::string_view(condition).substr(0, sign));
  const std::string wanted = sign == std::string::npos ? std::string() : trimmed(std::string_view(condition).substr(std::min(condition.size(), sign + (differs ? 2 : 1))));
  const int index = instance.slot_of(property);
  if (index < 0) return {};
  const Value& value = instance.read(index);
  if (holds(value, sign == std::string::npos ? "" : differs ? "!=" : "=", wanted)) return {};
  return "no effect: " + property + " is " + name_of_value(value);
}

lumen::PropertyState Session::state(const Instance& instance, int index) const {
  Slot& slot = *instance.slots()[index];
  lumen::PropertyState state;
  state.value = instance.read(index);
  state.spec = slot.spec;
  state.set = slot.set || !slot.unresolved.is_null();
  if (slot.link) {
    state.link = slot.link->path();
    if (slot.link->expression) state.expression = slot.link->expression->text();
  }
  state.error = error_of(slot);
  state.no_effect = no_effect(instance, slot);
  if (slot.spec.type == ValueType::data) {
    Slot* source = &slot;
    // Bounded: links of data may go in a circle.
    for (int step = 0; source && !source->spec.output && step < longest_data_chain; ++step) source = graph_.source(*source);
    state.data_state = source && source->spec.output ? source->data_state : slot.link ? "its source is not there" : "not linked";
  }
  return state;
}

std::vector<lumen::Problem> Session::problems() const {
  std::vector<lumen::Problem> result = contents_.problems;
  if (!restless_.empty())
    result.push_back({.severity = lumen::Severity::error, .message = "properties that keep changing each other: " + restless_});
  for (const auto* list : {&contents_.plugins, &contents_.views})
    for (const auto& instance : *list) {
      const auto problems = instance->problems();
      result.insert(result.end(), problems.begin(), problems.end());
    }
  return result;
}

void Session::report(lumen::Problem problem) {
  auto& problems = contents_.problems;
  if (problems.size() >= most_problems || std::find(problems.begin(), problems.end(), problem) != problems.end()) return;
  problems.push_back(std::move(problem));
  something_changed();
}

}  // namespace lumenshop
