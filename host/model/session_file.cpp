// Sessions as files: versions, what is kept although nobody knows it, saving.
#include <lumen/error.h>

#include "model/json_text.h"
#include "model/nearest_name.h"
#include "model/regular_file.h"
#include "model/session.h"

namespace lumenshop {

namespace {

constexpr int version = 1;
constexpr std::size_t largest_file = 64u << 20;

/// Step i makes version i + 1 of version i.
using Migration = void (*)(Json& session);
constexpr Migration migrations[] = {
    // 0, without a version, had the shape of 1.
    [](Json& session) { session["lumenshop"] = 1; },
};
static_assert(std::size(migrations) == version);

/// Brings it to this program's version. Throws lumen::Error if it is no session that can be read.
void migrate(Json& session, const std::string& name) {
  if (!session.is_object()) throw lumen::Error(name, "no session: the JSON is no object");
  for (const char* key : {"plugins", "views"})
    if (session.contains(key) && !session[key].is_object()) throw lumen::Error(name, std::string("no session: \"") + key + "\" is no object");
  if (!session.contains("lumenshop") && !session.contains("plugins"))
    throw lumen::Error(name, "no session: the key \"lumenshop\" is missing", "a session begins with { \"lumenshop\": 1, \"plugins\": ...");
  const Json number = session.value("lumenshop", Json(0));
  if (!number.is_number_integer() || number.get<double>() < 0) throw lumen::Error(name, "no session: \"lumenshop\" is no version number");
  if (number.get<double>() > version)
    throw lumen::Error(name, "made by a newer program: session version " + number.dump() + ", this one reads up to " + std::to_string(version),
                       "update the program; the file was not touched");
  for (int step = number.get<int>(); step < version; ++step) migrations[step](session);
}

}  // namespace

void Session::load(const std::filesystem::path& file) {
  const std::string text = read_regular_file(file, largest_file);
  std::vector<std::string> duplicates;
  Json json = parse_json(text, file.string(), &duplicates);
  const auto absolute = std::filesystem::absolute(file).lexically_normal();
  replace(std::move(json), absolute, absolute.parent_path(), file.string());
  for (const std::string& key : duplicates)
    report({.severity = lumen::Severity::warning, .file = file.string(), .message = "the key \"" + key.substr(0, 80) + "\" appears twice; the later one counts"});
}

void Session::load(const Json& json, const std::filesystem::path& folder) {
  replace(json, {}, std::filesystem::absolute(folder).lexically_normal(), "session");
}

void Session::replace(Json json, std::filesystem::path file, std::filesystem::path folder, const std::string& name) {
  migrate(json, name);
  if (!folder.has_filename() && folder.has_relative_path()) folder = folder.parent_path();  // no slash at the end
  Contents old = std::exchange(contents_, {});
  contents_.file = std::move(file);
  contents_.folder = std::move(folder);
  structure_changed();
  graph_.pause(true);
  try {
    fill(json);
  } catch (...) {
    graph_.pause(false);
    std::swap(contents_, old);
    structure_changed();
    throw;
  }
  graph_.pause(false);
  history_.clear();
  restless_.clear();
  structure_changed();
  saved_revision_ = ++document_revision_;
}

void Session::fill(const Json& json) {
  const auto keep = [&](const std::string& key, const Json& value, const std::string& why) {
    append(contents_.extra, key, value);
    contents_.problems.push_back({.severity = lumen::Severity::warning, .file = contents_.file.string(), .message = why + "; it is kept"});
  };
  for (const auto& [key, value] : json.items()) {
    if (key == "lumenshop" || key == "plugins" || key == "views") continue;
    if (key == "layout") contents_.layout = value;
    else if (key == "title" && value.is_string()) contents_.title = value.get<std::string>();
    else if (key == "title") keep(key, value, "\"title\" is no string");
    else keep(key, value, "this version does not know the session's \"" + key.substr(0, 80) + "\"");
  }
  // All ids first: links and references may point forward.
  std::vector<std::pair<Instance*, const Json*>> placed;
  if (json.contains("plugins")) fill_entries(json["plugins"], false, contents_.kept_plugins, placed);
  if (json.contains("views")) fill_entries(json["views"], true, contents_.kept_views, placed);
  for (const auto& [instance, entry] : placed) {
    Json properties = *entry;
    if (instance->type() != "view") properties.erase("type");
    instance->create(factory_, std::move(properties));
  }
}

void Session::fill_entries(const Json& entries, bool views, Json& kept, std::vector<std::pair<Instance*, const Json*>>& placed) {
  for (const auto& [id, entry] : entries.items()) {
    try {
      if (!entry.is_object()) throw lumen::Error(id.substr(0, 80), views ? "a view is an object of properties" : "a plugin is an object with a \"type\"");
      std::string type = "view";
      if (!views) {
        const auto found = entry.find("type");
        if (found == entry.end() || !found->is_string() || *found == "view") throw lumen::Error(id.substr(0, 80), "no plugin: it has no \"type\" of a plugin");
        type = found->get<std::string>();
      }
      check_free(id);
      placed.emplace_back(&place(id, type, -1), &entry);
    } catch (const lumen::Error& error) {
      append(kept, id, entry);
      contents_.problems.push_back({.severity = lumen::Severity::error, .instance = id.substr(0, 80), .file = contents_.file.string(),
                                    .message = std::string(error.what()) + "; it is kept as it is"});
    }
  }
}

Json Session::to_json(const std::filesystem::path& folder) const {
  Json result = Json::object();
  result["lumenshop"] = version;
  if (!title().empty()) result["title"] = title();
  Json entries = Json::object();
  for (const auto& instance : plugins()) {
    Json entry = Json::object();
    entry["type"] = instance->type();
    instance->table_->write_json(entry, folder);
    append(entries, instance->id(), std::move(entry));
  }
  for (const auto& [id, entry] : contents_.kept_plugins.items()) append(entries, id, entry);
  result["plugins"] = std::move(entries);
  entries = Json::object();
  for (const auto& view : views()) {
    Json entry = Json::object();
    view->table_->write_json(entry, folder);
    append(entries, view->id(), std::move(entry));
  }
  for (const auto& [id, entry] : contents_.kept_views.items()) append(entries, id, entry);
  if (!entries.empty()) result["views"] = std::move(entries);
  if (!layout().is_null()) result["layout"] = layout();
  for (const auto& [key, value] : contents_.extra.items()) append(result, key, value);
  return result;
}

Json Session::to_json() const { return to_json(folder()); }

void Session::save(const std::filesystem::path& file) {
  const auto absolute = std::filesystem::absolute(file).lexically_normal();
  write_file_atomically(absolute, json_text(to_json(absolute.parent_path())));
  contents_.file = absolute;
  contents_.folder = absolute.parent_path();
  saved_revision_ = document_revision_;
  something_changed();
}

}  // namespace lumenshop
