#include "model/instance.h"

#include <algorithm>

#include <lumen/interactor.h>

#include "model/nearest_name.h"
#include "model/plugin_factory.h"
#include "model/session.h"
#include "model/view.h"

namespace lumenshop {

namespace {

std::string short_text(const Json& json) {
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  return text.size() > 60 ? text.substr(0, 57) + "..." : text;
}

/// The object, owning its table beside it: whoever holds the object may outlive the instance.
std::shared_ptr<lumen::Plugin> bound(std::shared_ptr<PropertyTable> table, std::shared_ptr<lumen::Plugin> plugin) {
  if (!plugin) return nullptr;
  struct Both {
    std::shared_ptr<PropertyTable> table;
    std::shared_ptr<lumen::Plugin> plugin;  // goes first
  };
  auto both = std::make_shared<Both>(Both{std::move(table), std::move(plugin)});
  lumen::Plugin* object = both->plugin.get();
  return {std::move(both), object};
}

}  // namespace

Instance::Instance(Session& session, std::string id, std::string type)
    : session_(session), id_(std::move(id)), type_(std::move(type)), table_(std::make_shared<PropertyTable>(session, *this, Json::object())) {}

Instance::~Instance() {
  table_->close();
  plugin_.reset();
}

lumen::Kind Instance::kind() const {
  if (plugin_) return plugin_->kind();
  const std::string_view name = std::string_view(type_).substr(0, type_.find('.'));
  for (int kind = 0; kind <= static_cast<int>(lumen::Kind::view); ++kind)
    if (lumen::name_of(static_cast<lumen::Kind>(kind)) == name) return static_cast<lumen::Kind>(kind);
  return lumen::Kind::editor;  // of the kinds the one that touches no picture; without an object it does nothing at all
}

bool Instance::enabled() const {
  if (const int slot = slot_of("enabled"); slot >= 0) return std::get<bool>(read(slot));
  const auto kept = orphans().find("enabled");
  return kept == orphans().end() || !kept->is_boolean() || kept->get<bool>();
}

Instance::Object Instance::build(PluginFactory& factory, Json kept, PropertyTable* predecessor) {
  Object object;
  object.table = std::make_shared<PropertyTable>(session_, *this, std::move(kept));
  if (predecessor) object.table->inherit(*predecessor);
  try {
    auto plugin = type_ == "view" ? std::make_shared<View>(*object.table) : factory.create(type_, *object.table);
    object.generation = plugin && type_ != "view" ? factory.generation(type_) : 0;
    object.plugin = bound(object.table, std::move(plugin));
    object.table->constructed();
  } catch (const std::exception& error) {
    object.table->close();
    throw lumen::Error(id_, type_ + " could not be made: " + error.what());
  } catch (...) {
    object.table->close();
    throw lumen::Error(id_, type_ + " could not be made: its constructor threw something that is no std::exception");
  }
  return object;
}

void Instance::exchange(Object& object) {
  const Revisions before = revisions();
  std::swap(table_, object.table);
  std::swap(plugin_, object.plugin);
  std::swap(generation_, object.generation);
  table_->rename(id_);
  replaced_ = before.shading + 1;  // more than any sum so far, whatever the new table starts with
  revisions_ = {};
  was_enabled_ = enabled();
  failure_.clear();
  change_failures_.clear();
  session_.structure_changed();
}

void Instance::create(PluginFactory& factory, Json kept) {
  Object object;
  std::string failure;
  try {
    object = build(factory, kept, nullptr);
  } catch (const lumen::Error& error) {
    failure = error.what();
    object.table = std::make_shared<PropertyTable>(session_, *this, std::move(kept));
  }
  exchange(object);
  object.table->close();
  failure_ = std::move(failure);
}

const Instance::Revisions& Instance::revisions() const {
  const std::uint64_t values = session_.graph_.values();
  if (revisions_.values == values) return revisions_;
  std::uint64_t draw = replaced_, shading = replaced_;
  for (const auto& slot : slots()) {
    session_.graph_.refresh(*slot);
    if (slot->spec.options.affects == lumen::Affects::draw) draw += slot->revision;
    if (slot->spec.options.affects != lumen::Affects::nothing) shading += slot->revision;
  }
  revisions_ = {values, draw, shading};
  return revisions_;
}

std::shared_ptr<const void> Instance::take_lead() {
  if (!lead_.expired()) return nullptr;
  auto lead = std::make_shared<const char>();
  lead_ = lead;
  return lead;
}

std::uint64_t Instance::draw_revision() const { return revisions().draw; }
std::uint64_t Instance::shading_revision() const { return revisions().shading; }

std::vector<lumen::Problem> Instance::problems() const {
  std::vector<lumen::Problem> result;
  const auto add = [&](lumen::Severity severity, std::string message) {
    result.push_back({.severity = severity, .instance = id_, .message = std::move(message)});
  };
  if (!failure_.empty()) add(lumen::Severity::error, failure_);
  else if (!plugin_) add(lumen::Severity::error, "there is no plugin " + type_ + "; its properties are kept as they are");

  std::vector<std::string> declared;
  for (int index = 0; index < static_cast<int>(slots().size()); ++index) {
    const Slot& slot = *slots()[index];
    if (slot.retracted) continue;
    declared.push_back(slot.spec.id);
    session_.graph_.refresh(*slots()[index]);
    if (const std::string error = session_.error_of(slot); !error.empty())
      add(lumen::Severity::error, path_of(slot) + ": " + error);
  }
  if (plugin_)
    for (const auto& [property, json] : orphans().items()) {
      const auto slot = std::find_if(slots().begin(), slots().end(), [&](const auto& other) { return other->spec.id == property; });
      if (slot != slots().end()) continue;  // said above, or a run-time property that will return
      const std::string advice = suggestion(property, declared);
      add(lumen::Severity::warning, id_ + "." + property + ": " + type_ + " has no such property; " + short_text(json) + " is kept" +
                                        (advice.empty() ? "" : "; " + advice));
    }
  for (const std::string& conversion : table_->conversions()) add(lumen::Severity::warning, conversion);
  for (const auto& [property, failure] : change_failures_)
    add(lumen::Severity::error, id_ + ": failed when " + property + " changed: " + failure);
  result.insert(result.end(), table_->reports().begin(), table_->reports().end());
  return result;
}

void Instance::adopt(int index, lumen::DataPointer data, std::string state) {
  Slot& slot = *slots()[index];
  if (!slot.spec.output) throw lumen::Error(path_of(slot), "is no output");
  table_->adopt(slot, std::move(data), std::move(state));
}

}  // namespace lumenshop
