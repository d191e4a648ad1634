#include "model/property_table.h"

#include <algorithm>
#include <cmath>

#include "model/components.h"
#include "model/session.h"
#include "model/session_path.h"

namespace lumenshop {

using lumen::Value;
using lumen::ValueType;

namespace {

constexpr std::size_t most_slots = 65536, most_reports = 100, longest_id = 64;

bool is_property_id(std::string_view id) {
  const auto lower = [](char c) { return c >= 'a' && c <= 'z'; };
  if (id.empty() || id.size() > longest_id || !lower(id[0]) || id == "type") return false;
  return std::all_of(id.begin(), id.end(), [&](char c) { return lower(c) || (c >= '0' && c <= '9') || c == '_'; });
}

/// Throws lumen::Error for what no plugin should declare; mends what is merely left open.
void check(lumen::PropertySpec& spec, const std::string& where) {
  if (!is_property_id(spec.id)) throw lumen::Error(where, "no legal property id", "use [a-z][a-z0-9_]*, at most 64 letters, not 'type'");
  if (lumen::type_of(spec.default_value) != spec.type)
    throw lumen::Error(where, "its default is no " + std::string(lumen::name_of(spec.type)));
  if (!is_finite(spec.default_value)) throw lumen::Error(where, "its default is not finite");
  auto& options = spec.options;
  if (!(options.min <= options.max)) throw lumen::Error(where, "its range is empty");
  if (options.logarithmic && !(options.min > 0)) throw lumen::Error(where, "logarithmic needs a min above 0");
  if (auto* choice = std::get_if<lumen::Choice>(&spec.default_value)) {
    if (options.choices.empty()) throw lumen::Error(where, "a choice without choices");
    if (choice->name.empty()) choice->name = options.choices.front();
    if (std::find(options.choices.begin(), options.choices.end(), choice->name) == options.choices.end())
      throw lumen::Error(where, "its default '" + choice->name + "' is none of its choices");
  }
  spec.default_value = clamped(spec.default_value, spec);
}

Link link_of(const Json& json, const std::string& where) {
  const auto source = json.find("link");
  const auto expression = json.find("expression");
  const bool well_formed = source->is_string() && (expression == json.end() || expression->is_string()) &&
                           json.size() == (expression == json.end() ? 1u : 2u);
  if (!well_formed) throw lumen::Error(where, "a link is {\"link\": \"instance.property\"}, and may have an \"expression\"");
  const std::string& path = source->get_ref<const std::string&>();
  const auto dot = path.find('.');
  if (dot == 0 || dot == std::string::npos || dot + 1 == path.size())
    throw lumen::Error(where, "'" + path.substr(0, 80) + "' is no \"instance.property\" to link to");
  Link link{path.substr(0, dot), path.substr(dot + 1), nullptr};
  if (expression != json.end() && !expression->get_ref<const std::string&>().empty())
    link.expression = std::make_unique<Expression>(expression->get<std::string>());
  return link;
}

/// The message alone: whoever shows it names the property.
std::string without_place(const std::string& message, const Slot& slot) {
  for (const std::string& place : {path_of(slot) + ": ", slot.spec.id + ": "})
    if (message.rfind(place, 0) == 0) return message.substr(place.size());
  return message;
}

bool is_link(const Json& json) { return json.is_object() && json.contains("link"); }

bool has_value(const Slot& slot) { return slot.set || slot.link || !slot.unresolved.is_null(); }

}  // namespace

PropertyTable::PropertyTable(Session& session, Instance& owner, Json kept)
    : session_(&session), owner_(&owner), id_(owner.id()), kept_(std::move(kept)) {}
PropertyTable::~PropertyTable() = default;

int PropertyTable::slot_of(std::string_view property) const {
  const auto found = slot_by_id_.find(property);
  return found == slot_by_id_.end() || slots_[found->second]->retracted ? -1 : found->second;
}

int PropertyTable::declare(lumen::PropertySpec spec) {
  check(spec, id() + "." + spec.id);
  if (slot_of(spec.id) >= 0) throw lumen::Error(id() + "." + spec.id, "declared twice");
  if (slots_.size() >= most_slots) throw lumen::Error(id(), "more than " + std::to_string(most_slots) + " properties");

  // A property that returns keeps its slot, and with it the revision that readers know.
  const auto [place, fresh] = slot_by_id_.try_emplace(spec.id, static_cast<int>(slots_.size()));
  if (fresh) slots_.push_back(std::make_unique<Slot>());
  Slot& slot = *slots_[place->second];
  const std::uint64_t revision = fresh ? 1 : slot.revision + 1;
  slot = Slot{};
  slot.spec = std::move(spec);
  slot.owner = owner_;
  slot.own = slot.effective = slot.spec.default_value;
  slot.revision = revision;
  if (closed_) return place->second;

  if (const int old = predecessor_ ? predecessor_->slot_of(slot.spec.id) : -1; old >= 0) {
    inherit_value(slot, *predecessor_->slots_[old]);
  } else if (const auto found = kept_.find(slot.spec.id); found != kept_.end()) {
    const Json json = *found;
    apply(slot, json, session_->folder());
    if (!json.is_null() || slot.set) forget_kept(slot.spec.id);
  }
  session_->structure_changed();
  session_->graph_.refresh(slot);
  slot.notified = slot.revision;
  return place->second;
}

void PropertyTable::inherit_value(Slot& slot, Slot& old) {
  const bool same_type = slot.spec.type == old.spec.type && slot.spec.data_kind == old.spec.data_kind;
  const auto note = [&](const std::string& what) { conversions_.push_back(path_of(slot) + ": " + what); };
  const std::string was = "was " + std::string(lumen::name_of(old.spec.type)) + ", is " + std::string(lumen::name_of(slot.spec.type)) + " now; ";
  if (slot.spec.output) {
    if (same_type && old.spec.output) {  // the last good data stays until the new object has made its own
      slot.own = slot.effective = old.effective;
      slot.data_state = old.data_state;
    }
    slot.unresolved = old.unresolved;
    slot.error = old.error;
  } else if (old.link || !old.unresolved.is_null()) {
    if (same_type) slot.effective = old.effective;
    apply(slot, json(old, session_->folder()), session_->folder());
    if (!same_type && !slot.error.empty()) note(was + slot.error);
  } else if (old.set) {
    if (convertible(old.spec.type, slot.spec.type)) {
      slot.own = convert(old.own, slot.spec);
      slot.set = true;
      slot.relative = old.relative;
      if (!same_type) note(was + "its value was converted");
      else if (slot.own != old.own) note("its value is outside the new range and became " + lumenshop::to_json(slot.own).dump());
    } else {
      apply(slot, json(old, session_->folder()), session_->folder());  // JSON may still fit: an array is an array
      note(was + (slot.set ? "its value was taken over" : "its value does not fit and is kept in the session; the default is used"));
    }
    slot.effective = slot.own;
  }
  slot.revision = slot.effective == old.effective ? old.revision : old.revision + 1;
}

void PropertyTable::constructed() {
  constructing_ = false;
  for (const auto& slot : slots_) {
    session_->graph_.refresh(*slot);
    slot->notified = slot->revision;
  }
  if (!predecessor_) return;
  for (const auto& old : predecessor_->slots_)
    if (!old->retracted && slot_of(old->spec.id) < 0 && has_value(*old)) {
      forget_kept(old->spec.id);
      kept_[old->spec.id] = json(*old, session_->folder());
    }
  predecessor_ = nullptr;
}

void PropertyTable::retract(int index) {
  if (closed_) return;
  Slot& slot = *slots_[index];
  if (slot.retracted) return;
  if (has_value(slot)) {
    forget_kept(slot.spec.id);
    kept_[slot.spec.id] = json(slot, session_->folder());
  }
  slot.retracted = true;
  slot.link.reset();
  slot.unresolved = nullptr;
  slot.set = false;
  slot.error.clear();
  ++slot.revision;
  session_->structure_changed();
}

const Value& PropertyTable::read(int index) const {
  Slot& slot = *slots_[index];
  if (!closed_) session_->graph_.refresh(slot);
  return slot.effective;
}

std::uint64_t PropertyTable::revision(int index) const {
  Slot& slot = *slots_[index];
  if (!closed_) session_->graph_.refresh(slot);
  return slot.revision;
}

bool PropertyTable::is_set(int index) const { return slots_[index]->set || slots_[index]->link != nullptr; }

void PropertyTable::write(int index, Value value) {
  // What a constructor writes is a proposal: what a person or a file has set stays.
  if (constructing_) return write_default(index, std::move(value));
  if (!closed_) session_->write(*slots_[index], std::move(value), true);
}

void PropertyTable::write_default(int index, Value value) {
  if (closed_) return;
  Slot& slot = *slots_[index];
  if (lumen::type_of(value) != slot.spec.type || !is_finite(value)) throw lumen::Error(path_of(slot), "no fit default");
  value = clamped(std::move(value), slot.spec);
  if (value == slot.spec.default_value && (slot.set || slot.own == value)) return;
  slot.spec.default_value = value;
  if (!slot.set && !slot.spec.output) slot.own = std::move(value);
  if (!slot.link) show(slot, slot.own);
  session_->value_changed();
}

void PropertyTable::link(int index, const std::string& source, const std::string& expression) {
  if (closed_) return;
  Slot& slot = *slots_[index];
  if (!constructing_) return session_->link(slot, source, expression, true);
  // As with write(); and in a session that is being loaded the source may come later.
  if (has_value(slot)) return;
  Json json = Json::object();
  json["link"] = source;
  if (!expression.empty()) json["expression"] = expression;
  connect(slot, link_of(json, path_of(slot)));
}

void PropertyTable::unlink(int index) {
  if (!closed_ && !constructing_) session_->unlink(*slots_[index], true);
}

void PropertyTable::observe(const std::string& property, int change) {
  if (closed_) return;
  Watch& watch = watches_[property];
  if (watch.count == 0) watch.seen = session_->revision_of(property);
  watch.count += change;
  if (watch.count <= 0) watches_.erase(property);
}

void PropertyTable::report(lumen::Severity severity, const std::string& message) {
  if (closed_) return;
  lumen::Problem problem{.severity = severity, .instance = id(), .message = message};
  if (reports_.size() >= most_reports || std::find(reports_.begin(), reports_.end(), problem) != reports_.end()) return;
  reports_.push_back(std::move(problem));
  session_->something_changed();
}

void PropertyTable::show(Slot& slot, const Value& value) {
  if (slot.effective == value) return;
  slot.effective = value;
  ++slot.revision;
}

void PropertyTable::assign(Slot& slot, Value value, bool relative) {
  slot.own = clamped(std::move(value), slot.spec);
  slot.set = true;
  slot.relative = relative;
  slot.unresolved = nullptr;
  slot.error.clear();
  forget_kept(slot.spec.id);
  show(slot, slot.own);
  session_->value_changed();
}

void PropertyTable::clear(Slot& slot) {
  const bool linked = slot.link != nullptr;
  slot.link.reset();
  slot.set = slot.relative = false;
  slot.unresolved = nullptr;
  slot.error.clear();
  forget_kept(slot.spec.id);
  if (!slot.spec.output) {
    slot.own = slot.spec.default_value;
    show(slot, slot.own);
  }
  linked ? session_->structure_changed() : session_->value_changed();
}

void PropertyTable::connect(Slot& slot, Link link) {
  slot.link = std::make_unique<Link>(std::move(link));
  slot.followed = {};
  slot.set = false;
  slot.unresolved = nullptr;
  slot.error.clear();
  forget_kept(slot.spec.id);
  session_->structure_changed();
}

void PropertyTable::disconnect(Slot& slot) {
  session_->graph_.refresh(slot);
  slot.link.reset();
  slot.error.clear();
  if (slot.spec.type == ValueType::data) {
    slot.own = lumen::DataPointer{};
    show(slot, slot.own);
  } else {
    slot.own = slot.effective;
    slot.set = true;
  }
  session_->structure_changed();
}

void PropertyTable::adopt(Slot& slot, lumen::DataPointer data, std::string state) {
  slot.own = std::move(data);
  slot.data_state = std::move(state);
  show(slot, slot.own);
  session_->value_changed();
}

void PropertyTable::forget_kept(const std::string& property) { kept_.erase(property); }

void PropertyTable::apply(Slot& slot, const Json& json, const std::filesystem::path& folder) {
  slot.link.reset();
  slot.set = slot.relative = false;
  slot.unresolved = nullptr;
  slot.error.clear();
  slot.followed = {};
  try {
    if (slot.spec.output) throw lumen::Error(path_of(slot), "is an output: its plugin makes it");
    if (is_link(json)) {
      slot.own = slot.spec.default_value;
      slot.link = std::make_unique<Link>(link_of(json, path_of(slot)));
      return;
    }
    Value value = from_json(json, slot.spec);
    if (auto* path = std::get_if<lumen::Path>(&value)) slot.relative = make_absolute(*path, folder);
    slot.own = std::move(value);
    slot.set = true;
  } catch (const lumen::Error& error) {
    slot.own = slot.spec.default_value;
    slot.unresolved = json;
    slot.error = without_place(error.what(), slot);
  }
  if (!slot.spec.output) show(slot, slot.own);
}

void PropertyTable::restore(const std::string& property, const Json& json, const std::filesystem::path& folder) {
  const int index = slot_of(property);
  if (index < 0) {
    if (json.is_null()) forget_kept(property);
    else kept_[property] = json;
    session_->something_changed();
  } else if (json.is_null()) {
    clear(*slots_[index]);
  } else {
    apply(*slots_[index], json, folder);
    forget_kept(property);
    session_->structure_changed();
  }
}

Json PropertyTable::json(const Slot& slot, const std::filesystem::path& folder) const {
  if (!slot.unresolved.is_null()) return slot.unresolved;
  if (slot.link) {
    Json result = Json::object();
    result["link"] = slot.link->path();
    if (slot.link->expression) result["expression"] = slot.link->expression->text();
    return result;
  }
  if (!slot.set) return nullptr;
  if (const auto* path = std::get_if<lumen::Path>(&slot.own)) return path_in_session(*path, slot.relative, folder);
  return lumenshop::to_json(slot.own);
}

void PropertyTable::write_json(Json& object, const std::filesystem::path& folder) const {
  for (const auto& slot : slots_)
    if (!slot->retracted)
      if (Json value = json(*slot, folder); !value.is_null()) object[slot->spec.id] = std::move(value);
  for (const auto& [property, value] : kept_.items())
    if (!object.contains(property)) object[property] = value;
}

}  // namespace lumenshop
