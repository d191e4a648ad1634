// A session's structure: instances by id, and how they come and go.
#include "model/session.h"

#include <algorithm>

#include "model/nearest_name.h"

namespace lumenshop {

namespace {

constexpr std::size_t most_instances = 4096;

std::vector<std::string> ids_of(const std::map<std::string, Instance*, std::less<>>& by_id) {
  std::vector<std::string> ids;
  for (const auto& [id, instance] : by_id) ids.push_back(id);
  return ids;
}

std::vector<std::string> properties_of(const Instance& instance) {
  std::vector<std::string> ids;
  for (const auto& slot : instance.slots())
    if (!slot->retracted) ids.push_back(slot->spec.id);
  return ids;
}

bool is_instance_id(std::string_view id) {
  const auto letter = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); };
  return !id.empty() && id.size() <= 128 && letter(id[0]) &&
         std::all_of(id.begin(), id.end(), [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; });
}

}  // namespace

Session::Session(PluginFactory& factory) : factory_(factory) { contents_.folder = std::filesystem::current_path(); }
Session::~Session() = default;

Instance* Session::find(std::string_view id) const {
  const auto found = contents_.by_id.find(id);
  return found == contents_.by_id.end() ? nullptr : found->second;
}

std::pair<Instance*, int> Session::resolve(std::string_view path) const {
  const auto dot = path.find('.');
  if (dot == std::string_view::npos || dot == 0 || dot + 1 == path.size())
    throw lumen::Error(std::string(path.substr(0, 200)), "is no property", "name it as instance.property");
  const std::string id(path.substr(0, dot)), property(path.substr(dot + 1));
  Instance* instance = find(id);
  if (!instance) throw lumen::Error(std::string(path), "there is no instance '" + id + "'", suggestion(id, ids_of(contents_.by_id)));
  const int slot = instance->slot_of(property);
  if (slot >= 0) return {instance, slot};
  if (!instance->plugin()) throw lumen::Error(std::string(path), "the plugin " + instance->type() + " is not there");
  throw lumen::Error(std::string(path), instance->type() + " has no property '" + property + "'", suggestion(property, properties_of(*instance)));
}

Slot& Session::slot_at(std::string_view path) const {
  const auto [instance, slot] = resolve(path);
  return *instance->slots()[slot];
}

std::uint64_t Session::revision_of(std::string_view path) const {
  const auto dot = path.find('.');
  const Instance* instance = dot == std::string_view::npos ? nullptr : find(path.substr(0, dot));
  const int slot = instance ? instance->slot_of(path.substr(dot + 1)) : -1;
  return slot < 0 ? 0 : instance->revision(slot);
}

void Session::check_free(const std::string& id) const {
  if (!is_instance_id(id)) throw lumen::Error("'" + id.substr(0, 80) + "'", "no legal id", "use letters, digits and _, a letter first");
  if (find(id) || contents_.kept_plugins.contains(id) || contents_.kept_views.contains(id)) throw lumen::Error(id, "the id is taken");
  if (contents_.by_id.size() >= most_instances)
    throw lumen::Error(id, "a session has at most " + std::to_string(most_instances) + " instances");
}

Instance& Session::add(const std::string& type, std::string id) {
  if (type != "view" && !factory_.has(type)) throw lumen::Error(type, "there is no such plugin");
  if (id.empty()) {
    const std::string name = type.substr(type.find('.') == std::string::npos ? 0 : type.find('.') + 1);
    id = name;
    for (int number = 2; find(id) || contents_.kept_plugins.contains(id) || contents_.kept_views.contains(id); ++number)
      id = name + std::to_string(number);
  }
  check_free(id);
  Instance& instance = place(id, type, -1);
  instance.create(factory_, Json::object());
  if (!instance.plugin()) {
    const std::string failure = instance.failure_.empty() ? type + " could not be made" : instance.failure_;
    erase(instance);
    throw lumen::Error(failure);
  }
  record({.instance = id, .before = nullptr, .after = json_of(instance), .position = position_of(instance), .folder = folder()});
  return instance;
}

void Session::remove(const std::string& id) {
  Instance* instance = find(id);
  if (!instance) throw lumen::Error(id, "there is no such instance", suggestion(id, ids_of(contents_.by_id)));
  Change change{.instance = id, .before = json_of(*instance), .after = nullptr, .position = position_of(*instance), .folder = folder()};
  erase(*instance);
  record(std::move(change));
}

void Session::rename(const std::string& id, const std::string& to) {
  Instance* renamed = find(id);
  if (!renamed) throw lumen::Error(id, "there is no such instance", suggestion(id, ids_of(contents_.by_id)));
  if (id == to) return;
  check_free(to);
  begin_edit();
  give_id(*renamed, to);
  record({.instance = id, .before = id, .after = to, .folder = folder()});

  const auto is_link_to = [&](const Json& json) {
    return json.is_object() && json.contains("link") && json["link"].is_string() && json["link"].get_ref<const std::string&>().rfind(id + ".", 0) == 0;
  };
  for (const auto& [other_id, instance] : contents_.by_id) {
    const std::shared_ptr<PropertyTable> table = instance->table_;
    Json properties = Json::object();
    table->write_json(properties, folder());
    for (const auto& [property, before] : properties.items()) {
      Json after = before;
      const int slot = table->slot_of(property);
      const auto type = slot < 0 ? lumen::ValueType::data : table->spec(slot).type;
      if (is_link_to(after)) after["link"] = to + after["link"].get<std::string>().substr(id.size());
      else if (type == lumen::ValueType::reference && after == Json(id)) after = to;
      else if (type == lumen::ValueType::references && after.is_array()) std::replace(after.begin(), after.end(), Json(id), Json(to));
      if (after == before) continue;
      table->restore(property, after, folder());
      record({.instance = other_id, .property = property, .before = before, .after = after, .folder = folder()});
    }
  }
  end_edit();
}

void Session::record(Change change) {
  ++document_revision_;
  if (quiet_ == 0) history_.record(std::move(change));
}

Instance& Session::place(const std::string& id, const std::string& type, int position) {
  auto& list = type == "view" ? contents_.views : contents_.plugins;
  const bool last = position < 0 || position >= static_cast<int>(list.size());
  Instance& instance = **list.insert(last ? list.end() : list.begin() + position, std::make_unique<Instance>(*this, id, type));
  contents_.by_id[id] = &instance;
  if (!last) renumber();
  else if (type != "view") instance.number_ = static_cast<int>(list.size());
  structure_changed();
  return instance;
}

Instance& Session::insert(const std::string& id, const Json& json, int position, const std::filesystem::path& folder) {
  Instance& instance = place(id, json.at("type").get<std::string>(), position);
  Json properties = json;
  properties.erase("type");
  const auto here = std::exchange(contents_.folder, folder);
  instance.create(factory_, std::move(properties));
  contents_.folder = here;
  return instance;
}

void Session::erase(Instance& instance) {
  // What it drives keeps the value that it has now, even if nobody has read it yet.
  for (const auto& [id, other] : contents_.by_id)
    for (const auto& slot : other->slots()) graph_.refresh(*slot);
  auto& list = instance.type() == "view" ? contents_.views : contents_.plugins;
  const auto found = std::find_if(list.begin(), list.end(), [&](const auto& other) { return other.get() == &instance; });
  const std::unique_ptr<Instance> gone = std::move(*found);  // ends when nothing finds it any more
  list.erase(found);
  contents_.by_id.erase(instance.id());
  renumber();
  structure_changed();
}

void Session::give_id(Instance& instance, const std::string& to) {
  const std::string from = instance.id_;
  contents_.by_id.erase(from);
  instance.id_ = to;
  instance.table_->rename(to);
  contents_.by_id[to] = &instance;
  history_.renamed(from, to);
  structure_changed();
}

void Session::replay(const Change& change, bool forward) {
  ++document_revision_;
  const Json& to = forward ? change.after : change.before;
  if (change.property.empty() && change.before.is_string() && change.after.is_string()) {
    Instance* instance = find((forward ? change.before : change.after).get<std::string>());
    if (instance && !find(to.get<std::string>())) give_id(*instance, to.get<std::string>());
  } else if (change.property.empty()) {
    Instance* instance = find(change.instance);
    if (to.is_null() && instance) erase(*instance);
    if (!to.is_null() && !instance) insert(change.instance, to, change.position, change.folder);
  } else if (Instance* instance = find(change.instance)) {
    const std::shared_ptr<PropertyTable> table = instance->table_;
    table->restore(change.property, to, change.folder);
  }
}

int Session::position_of(const Instance& instance) const {
  const auto& list = instance.type() == "view" ? contents_.views : contents_.plugins;
  return static_cast<int>(std::find_if(list.begin(), list.end(), [&](const auto& other) { return other.get() == &instance; }) - list.begin());
}

void Session::renumber() {
  int number = 0;
  for (const auto& instance : contents_.plugins) instance->number_ = ++number;
}

Json Session::json_of(const Instance& instance) const {
  Json json = Json::object();
  json["type"] = instance.type();
  instance.table_->write_json(json, folder());
  return json;
}

}  // namespace lumenshop
