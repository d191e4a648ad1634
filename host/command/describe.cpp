/// `lumenshop describe`: every plugin and property, for people or as JSON.
#include <cmath>
#include <cstdio>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <lumen/error.h>

#include "command/commands.h"
#include "model/session.h"
#include "workshop.h"

namespace lumenshop {
namespace {

struct Description {
  TypeInfo type;
  const Instance* instance = nullptr;  ///< null: its constructor failed
  std::string failure;
};

Json limit(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// What a property takes or gives, in a word or two: "float", "reference to diffuse", "mesh (output)".
std::string type_text(const lumen::PropertySpec& spec) {
  if (spec.type == lumen::ValueType::data)
    return std::string(lumen::name_of(spec.data_kind)) + (spec.output ? " (output)" : " (input)");
  std::string text(lumen::name_of(spec.type));
  if (!spec.options.accepts.empty() && (spec.type == lumen::ValueType::reference || spec.type == lumen::ValueType::references))
    text += " to " + spec.options.accepts;
  return text;
}

Json property_json(const lumen::PropertySpec& spec) {
  Json json{{"id", spec.id}, {"type", lumen::name_of(spec.type)}};
  if (spec.type == lumen::ValueType::data) {
    json["data"] = lumen::name_of(spec.data_kind);
    json["output"] = spec.output;
  } else {
    json["default"] = to_json(spec.default_value);
  }
  const lumen::PropertyOptions& options = spec.options;
  json["min"] = limit(options.min);
  json["max"] = limit(options.max);
  json["unit"] = options.unit;
  json["doc"] = options.doc;
  if (options.step > 0) json["step"] = options.step;
  if (!options.group.empty()) json["group"] = options.group;
  if (!options.when.empty()) json["when"] = options.when;
  if (!options.accepts.empty()) json["accepts"] = options.accepts;
  if (!options.choices.empty()) json["choices"] = options.choices;
  for (const auto& [name, value] : {std::pair{"logarithmic", options.logarithmic}, {"advanced", options.advanced}, {"constant", options.constant}})
    if (value) json[name] = true;
  return json;
}

Json type_json(const Description& description) {
  Json json{{"type", description.type.id}, {"kind", lumen::name_of(description.type.kind)}, {"doc", description.type.doc},
            {"library", description.type.library.filename().string()}};
  if (!description.instance) {
    json["error"] = description.failure;
    return json;
  }
  json["properties"] = Json::array();
  for (const auto& slot : description.instance->slots())
    if (!slot->retracted) json["properties"].push_back(property_json(slot->spec));
  if (const lumen::Plugin* plugin = description.instance->plugin()) {
    for (const lumen::Reads* reads : plugin->reads()) json["reads"].push_back(reads->layer());
    for (const lumen::Writes* writes : plugin->writes()) json["writes"].push_back(writes->layer());
  }
  return json;
}

std::string range_text(const lumen::PropertySpec& spec) {
  const lumen::PropertyOptions& options = spec.options;
  if (!options.choices.empty()) return fmt::format("{}", fmt::join(options.choices, " | "));
  if (!std::isfinite(options.min) && !std::isfinite(options.max)) return {};
  return fmt::format("{}..{}", std::isfinite(options.min) ? fmt::format("{:g}", options.min) : "", std::isfinite(options.max) ? fmt::format("{:g}", options.max) : "");
}

void print(const Description& description) {
  fmt::print("{}  {}\n", description.type.id, description.type.doc);
  if (!description.instance) fmt::print("  cannot be made: {}\n", description.failure);
  else
    for (const auto& slot : description.instance->slots()) {
      if (slot->retracted) continue;
      const lumen::PropertySpec& spec = slot->spec;
      std::string facts = type_text(spec);
      if (const std::string range = range_text(spec); !range.empty()) facts += ", " + range;
      if (!spec.options.unit.empty()) facts += " " + spec.options.unit;
      if (spec.type != lumen::ValueType::data) facts += " (default: " + to_json(spec.default_value).dump() + ")";
      fmt::print("  {:<18} {}\n  {:<18} {}\n", spec.id, facts, "", spec.options.doc);
    }
}

}  // namespace

int run_describe(const DescribeOptions& options, const std::vector<std::filesystem::path>& plugin_folders) {
  Workshop workshop({.plugin_folders = plugin_folders});
  Session& scratch = workshop.session();
  scratch.load(Json{{"lumenshop", 1}, {"views", {{"main", Json::object()}}}}, std::filesystem::current_path());

  std::vector<TypeInfo> types = workshop.registry().types();
  types.push_back({.id = "view", .doc = "what one picture is made of", .source = {}, .kind = lumen::Kind::view, .library = {}});
  std::vector<Description> chosen;
  std::string known;
  for (const TypeInfo& type : types) {
    known += " " + type.id;
    if (!options.type.empty() && options.type != type.id) continue;
    Description description{type};
    try {
      description.instance = type.kind == lumen::Kind::view ? scratch.views().front().get() : &scratch.add(type.id);
    } catch (const lumen::Error& error) {
      description.failure = error.what();
    }
    chosen.push_back(std::move(description));
  }
  if (chosen.empty()) throw lumen::Error(options.type, "no such plugin", "there are:" + known);

  if (options.json) {
    Json all = Json::array();
    for (const Description& description : chosen) all.push_back(type_json(description));
    fmt::print("{}\n", (options.type.empty() ? all : all.front()).dump(2));
  } else {
    for (const Description& description : chosen) {
      if (&description != &chosen.front()) fmt::print("\n");
      print(description);
    }
  }
  return exit_well;
}

}  // namespace lumenshop
