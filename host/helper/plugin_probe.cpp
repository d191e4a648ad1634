#include "helper/plugin_probe.h"

#include <cmath>
#include <memory>

#include <nlohmann/json.hpp>

#include "helper/probe_binding.h"
#include "modules/handshake.h"
#include "modules/load_library.h"

namespace lumenshop {

namespace {

using Json = nlohmann::ordered_json;
constexpr int repetitions = 100;

Json describe(const lumen::PropertySpec& spec) {
  const lumen::PropertyOptions& options = spec.options;
  Json json{{"id", spec.id}, {"type", lumen::name_of(spec.type)}, {"doc", options.doc}};
  if (std::isfinite(options.min)) json["min"] = options.min;
  if (std::isfinite(options.max)) json["max"] = options.max;
  if (!options.unit.empty()) json["unit"] = options.unit;
  if (!options.choices.empty()) json["choices"] = options.choices;
  if (!options.accepts.empty()) json["accepts"] = options.accepts;
  if (spec.type == lumen::ValueType::data) json["data"] = lumen::name_of(spec.data_kind);
  if (spec.output) json["output"] = true;
  return json;
}

std::unique_ptr<lumen::Plugin> create(const lumen::PluginType& type, ProbeBinding& binding) {
  try {
    std::unique_ptr<lumen::Plugin> plugin(type.create(binding));
    if (!plugin) throw lumen::Error(type.id, "its constructor function made nothing");
    return plugin;
  } catch (const std::exception& error) {
    throw lumen::Error(type.id, std::string("its constructor threw: ") + error.what());
  } catch (...) {
    throw lumen::Error(type.id, "its constructor threw something that is no std::exception");
  }
}

void try_type(const lumen::PluginType& type, Json& description, Json& complaints, const std::function<void(const std::string&)>& stage) {
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    ProbeBinding binding(type.id);
    if (repetition == 0) stage("creating " + std::string(type.id));
    std::unique_ptr<lumen::Plugin> plugin = create(type, binding);
    if (plugin->kind() != *kind_of(type.id)) throw lumen::Error(type.id, "its class is of the kind " + std::string(lumen::name_of(plugin->kind())));
    if (repetition == 0) {
      for (const ProbeBinding::Entry& entry : binding.entries()) description["properties"].push_back(describe(entry.spec));
      for (const std::string& complaint : binding.complaints()) complaints.push_back(std::string(type.id) + "." + complaint);
      stage("destroying " + std::string(type.id));
    }
    plugin.reset();
  }
}

}  // namespace

std::string probe_library(const std::filesystem::path& library, int level, const std::function<void(const std::string&)>& stage) {
  const std::string name = library.filename().string();
  stage("loading");
  void* const handle = load_library(library, name);
  Json result{{"types", Json::array()}, {"complaints", Json::array()}};
  if (level >= 2) {
    stage("reading its table");
    const auto* const table = static_cast<const lumen::PluginTable*>(find_symbol(handle, "lumen_plugins"));
    check_table(table, name);
    for (const lumen::PluginType* type = table->begin; type != table->end; ++type) {
      Json description{{"id", type->id}, {"doc", type->doc}, {"source", type->source}};
      if (*type->doc == '\0') result["complaints"].push_back(std::string(type->id) + ": it has no doc");
      if (level >= 3) try_type(*type, description, result["complaints"], stage);
      result["types"].push_back(std::move(description));
    }
  }
  return result.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace lumenshop
