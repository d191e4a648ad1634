#include "window/settings.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include <nlohmann/json.hpp>

namespace lumenshop {
namespace {

constexpr std::size_t most_recent = 10;
constexpr std::uintmax_t longest_file = 1 << 20;

const char* name_of(lumen::ui::Theme theme) {
  switch (theme) {
    case lumen::ui::Theme::light: return "light";
    case lumen::ui::Theme::high_contrast: return "high contrast";
    case lumen::ui::Theme::dark: break;
  }
  return "dark";
}

void read(const nlohmann::json& json, const char* key, bool& value) {
  if (json.contains(key) && json[key].is_boolean()) value = json[key].get<bool>();
}
void read(const nlohmann::json& json, const char* key, float& value, float low, float high) {
  if (json.contains(key) && json[key].is_number()) value = std::clamp(json[key].get<float>(), low, high);
}

}  // namespace

Settings Settings::load(const std::filesystem::path& file) {
  Settings settings;
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error) || std::filesystem::file_size(file, error) > longest_file) return settings;
  std::ifstream stream(file);
  const auto json = nlohmann::json::parse(stream, nullptr, false);
  if (!json.is_object()) return settings;
  read(json, "outline", settings.panels.outline, Layout::smallest, 2000);
  read(json, "properties", settings.panels.properties, Layout::smallest, 2000);
  read(json, "bottom", settings.panels.bottom, 60, 2000);
  read(json, "outline_open", settings.panels.outline_open);
  read(json, "properties_open", settings.panels.properties_open);
  read(json, "bottom_open", settings.panels.bottom_open);
  read(json, "scale", settings.user_scale, 0.75f, 3);
  read(json, "blender_keys", settings.blender_keys);
  read(json, "reduced_motion", settings.reduced_motion);
  if (json.contains("bottom_panel") && json["bottom_panel"].is_string()) settings.bottom_panel = json["bottom_panel"].get<std::string>();
  const std::string theme = json.contains("theme") && json["theme"].is_string() ? json["theme"].get<std::string>() : "";
  for (const auto each : {lumen::ui::Theme::light, lumen::ui::Theme::high_contrast})
    if (theme == name_of(each)) settings.theme = each;
  if (json.contains("recent") && json["recent"].is_array())
    for (const auto& entry : json["recent"])
      if (entry.is_string() && settings.recent.size() < most_recent) settings.recent.push_back(entry.get<std::string>());
  return settings;
}

void Settings::save(const std::filesystem::path& file) const {
  nlohmann::ordered_json json;
  json["theme"] = name_of(theme);
  json["scale"] = user_scale;
  json["outline"] = panels.outline;
  json["properties"] = panels.properties;
  json["bottom"] = panels.bottom;
  json["outline_open"] = panels.outline_open;
  json["properties_open"] = panels.properties_open;
  json["bottom_open"] = panels.bottom_open;
  json["bottom_panel"] = bottom_panel;
  json["blender_keys"] = blender_keys;
  json["reduced_motion"] = reduced_motion;
  json["recent"] = recent;
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);
  const std::filesystem::path aside = file.string() + ".new";
  std::ofstream stream(aside);
  stream << json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
  stream.close();
  if (stream) std::filesystem::rename(aside, file, error);
}

void Settings::remember(const std::filesystem::path& session) {
  std::error_code error;
  const std::string path = std::filesystem::absolute(session, error).string();
  std::erase(recent, path);
  recent.insert(recent.begin(), path);
  if (recent.size() > most_recent) recent.resize(most_recent);
}

}  // namespace lumenshop
