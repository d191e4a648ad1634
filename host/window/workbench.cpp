#include "window/workbench.h"

#include <algorithm>
#include <limits>

#include <nlohmann/json.hpp>

#include <lumen/interactor.h>

#include "format_catalog.h"
#include "frame/shader_library.h"
#include "installation.h"
#include "material_capture.h"
#include "model/json_value.h"
#include "window/open_editor.h"
#include "window/view_trial.h"

namespace lumenshop {
namespace {

constexpr double loaded_seconds = 3;
constexpr std::size_t longest_orphan = 200;

}  // namespace

SessionWorkbench::SessionWorkbench(Workshop& workshop, std::function<void(const std::string&)> notice, std::function<void()> wake)
    : workshop_(workshop), notice_(std::move(notice)), shelf_(workshop.registry(), &workshop.helper(), std::move(wake)) {
  for (TypeInfo& type : workshop_.registry().types()) types_[type.id] = type;
}

template <class Action>
void SessionWorkbench::attempt(Action action) {
  try {
    action();
  } catch (const lumen::Error& error) {
    notice_(error.what());
  }
}

void SessionWorkbench::reloaded(const ReloadEvent& event, double now) {
  types_.clear();
  addable_.clear();
  for (TypeInfo& type : workshop_.registry().types()) types_[type.id] = type;
  switch (event.state) {
    case BuildState::loaded: badges_[event.library] = {"loaded", now + loaded_seconds}; break;
    case BuildState::kept: badges_[event.library] = {"kept " + std::to_string(event.generation), 0}; break;
    case BuildState::building: badges_[event.library] = {"building", 0}; break;
    case BuildState::idle: badges_.erase(event.library); break;
  }
}

void SessionWorkbench::tick(double now) {
  std::erase_if(badges_, [&](const auto& entry) { return entry.second.until > 0 && entry.second.until <= now; });
}

double SessionWorkbench::next_tick() const {
  double next = 0;
  for (const auto& [library, badge] : badges_)
    if (badge.until > 0) next = next > 0 ? std::min(next, badge.until) : badge.until;
  return next;
}

std::string SessionWorkbench::badge_of(const std::string& type) const {
  const auto info = types_.find(type);
  if (info == types_.end()) return {};
  const auto badge = badges_.find(info->second.library.stem().string());
  return badge == badges_.end() ? std::string() : badge->second.text;
}

lumen::InstanceState SessionWorkbench::state_of(const Instance& instance) const {
  lumen::InstanceState state;
  state.id = instance.id();
  state.type = instance.type();
  state.kind = instance.kind();
  state.known = instance.plugin() != nullptr;
  state.enabled = instance.enabled();
  state.generation = instance.generation();
  state.badge = badge_of(instance.type());
  if (const auto* interactor = instance.as<lumen::Interactor>(lumen::Kind::interactor)) {
    state.camera = interactor->is_camera();
    state.light = interactor->is_light();
  }
  if (const auto info = types_.find(instance.type()); info != types_.end()) {
    state.doc = info->second.doc;
    state.source = info->second.source;
  }
  for (const auto& slot : instance.slots()) {
    const auto* data = std::get_if<lumen::DataPointer>(&slot->effective);
    if (slot->spec.output && data && *data && state.summary.empty()) state.summary = (*data)->summary();
  }
  for (const auto& [name, json] : instance.orphans().items())
    state.orphans.push_back(name + ": " + json.dump(-1, ' ', false, Json::error_handler_t::replace).substr(0, longest_orphan));
  return state;
}

std::vector<lumen::InstanceState> SessionWorkbench::instances() const {
  std::vector<lumen::InstanceState> states;
  for (const auto& view : session().views()) states.push_back(state_of(*view));
  for (const auto& plugin : session().plugins()) states.push_back(state_of(*plugin));
  return states;
}

std::vector<lumen::PropertyState> SessionWorkbench::properties(const std::string& id) const {
  std::vector<lumen::PropertyState> states;
  const Instance* instance = session().find(id);
  if (!instance) return states;
  const auto& slots = instance->slots();
  for (std::size_t slot = 0; slot < slots.size(); ++slot)
    if (!slots[slot]->retracted) states.push_back(session().state(*instance, static_cast<int>(slot)));
  return states;
}

std::optional<lumen::PropertyState> SessionWorkbench::property(const std::string& path) const {
  const auto dot = path.find('.');
  if (dot == std::string::npos) return std::nullopt;
  const Instance* instance = session().find(path.substr(0, dot));
  const int slot = instance ? instance->slot_of(path.substr(dot + 1)) : -1;
  if (slot < 0) return std::nullopt;
  return session().state(*instance, slot);
}

void SessionWorkbench::set(const std::string& path, lumen::Value value) {
  attempt([&] { session().set(path, std::move(value)); });
}
void SessionWorkbench::reset(const std::string& path) {
  attempt([&] { session().reset(path); });
}
void SessionWorkbench::begin_edit() { session().begin_edit(); }
void SessionWorkbench::end_edit() { session().end_edit(); }
void SessionWorkbench::cancel_edit() { session().cancel_edit(); }

void SessionWorkbench::link(const std::string& path, const std::string& source, const std::string& expression) {
  session().link(path, source, expression);
}
void SessionWorkbench::unlink(const std::string& path) {
  attempt([&] { session().unlink(path); });
}
std::vector<std::string> SessionWorkbench::linkable(const std::string& path) const { return session().linkable(path); }

std::string SessionWorkbench::to_json(const lumen::Value& value) const {
  return lumenshop::to_json(value).dump(-1, ' ', false, Json::error_handler_t::replace);
}

lumen::Value SessionWorkbench::from_json(const std::string& path, const std::string& text) const {
  const auto [instance, slot] = session().resolve(path);
  Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) json = text;  // a plain text is what a person pastes into a string
  return lumenshop::from_json(json, instance->spec(slot));
}

std::unique_ptr<lumen::Trial> SessionWorkbench::trial(const std::string& view, const std::string& instance, const std::vector<std::string>& layers) {
  return std::make_unique<ViewTrial>(workshop_, view, instance, layers);
}

std::string SessionWorkbench::selection() const { return session().find(selection_) ? selection_ : std::string(); }
void SessionWorkbench::select(const std::string& instance) { selection_ = instance; }

std::vector<lumen::Problem> SessionWorkbench::problems() const {
  auto problems = workshop_.problems();
  if (reloader_) {
    const auto more = reloader_->problems();
    problems.insert(problems.end(), more.begin(), more.end());
  }
  // Two parts of the program may name the same thing.
  std::vector<lumen::Problem> unique;
  for (lumen::Problem& problem : problems)
    if (std::find(unique.begin(), unique.end(), problem) == unique.end()) unique.push_back(std::move(problem));
  return unique;
}

std::vector<lumen::TypeState> SessionWorkbench::types() const {
  if (!addable_.empty()) return addable_;
  // Only an interactor itself knows what it can be to a view.
  Session trial(workshop_.registry());
  for (const auto& [id, info] : types_) {
    lumen::TypeState state{.id = id, .doc = info.doc, .kind = info.kind};
    if (info.kind == lumen::Kind::interactor) {
      const auto* interactor = trial.add(id).as<lumen::Interactor>(lumen::Kind::interactor);
      state.camera = interactor != nullptr && interactor->is_camera();
      state.light = interactor != nullptr && interactor->is_light();
    }
    addable_.push_back(std::move(state));
  }
  return addable_;
}

std::string SessionWorkbench::add(const std::string& type, const std::string& properties) {
  const Json values = Json::parse(properties, nullptr, false);
  if (!values.is_object()) throw lumen::Error(type, "its values are no JSON object");
  session().begin_edit();
  std::string id;
  try {
    id = session().add(type).id();
    for (const auto& [property, value] : values.items()) session().set(id + "." + property, value);
  } catch (...) {
    if (!id.empty()) session().remove(id);
    session().end_edit();
    throw;
  }
  session().end_edit();
  return id;
}

std::string SessionWorkbench::gallery() const { return Installation::user_gallery().string(); }

std::string SessionWorkbench::capture(const std::string& surface) {
  if (session().views().empty()) throw lumen::Error(surface, "there is no view whose lights could shine on it");
  ShaderLibrary shaders(workshop_.shader_folders());
  auto picture = captured_material(session(), surface, session().views().front()->id(), workshop_.registry(), shaders);
  const FormatCatalog formats(workshop_.registry());
  return save_material(workshop_.scheduler(), formats.exporter_of("material.exr", lumen::DataKind::image), std::move(picture), gallery(), surface).string();
}

void SessionWorkbench::open_source(const std::string& file, int line) {
  attempt([&] { open_in_editor(file, line); });
}

}  // namespace lumenshop
