/// `lumenshop new`: writes a plugin from the installation's template of its kind.
///
/// In a source tree: the plugin, its shader and its test in their folders, which the build finds by itself. Elsewhere: a
/// folder of its own with a CMakeLists.txt and a test.
#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <lumen/error.h>

#include "command/commands.h"
#include "installation.h"
#include "model/json_value.h"

namespace lumenshop {
namespace {

using Path = std::filesystem::path;
using Words = std::map<std::string, std::string>;  ///< what stands for @KEY@

std::string read(const Path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw lumen::Error(file.string(), "cannot be read");
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string filled(std::string text, const Words& words) {
  for (const auto& [key, word] : words) {
    const std::string mark = "@" + key + "@";
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + word.size())) text.replace(at, mark.size(), word);
  }
  return text;
}

/// "my_toon" -> "MyToon", or "My toon".
std::string camel(const std::string& name) {
  std::string result;
  bool upper = true;
  for (const char c : name) {
    if (c != '_') result += upper ? char(std::toupper(static_cast<unsigned char>(c))) : c;
    upper = c == '_';
  }
  return result;
}

std::string title(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  name.front() = char(std::toupper(static_cast<unsigned char>(name.front())));
  return name;
}

void check(const NewOptions& options, const Path& templates) {
  if (!std::filesystem::is_directory(templates / options.kind) || options.kind.find('/') != std::string::npos) {
    std::string kinds;
    for (const auto& entry : std::filesystem::directory_iterator(templates))
      if (entry.is_directory()) kinds += " " + entry.path().filename().string();
    throw UsageError(options.kind + ": no such kind of plugin; there are" + kinds);
  }
  const bool well_formed = !options.name.empty() && std::islower(static_cast<unsigned char>(options.name.front())) &&
                           std::all_of(options.name.begin(), options.name.end(),
                                       [](unsigned char c) { return std::islower(c) || std::isdigit(c) || c == '_'; });
  if (!well_formed) throw UsageError(options.name + ": expected a name of lower-case letters, digits and _, as in my_toon");
}

/// All or nothing: a file that is there already is never replaced.
void write(const std::map<Path, std::string>& files) {
  for (const auto& [file, text] : files)
    if (std::filesystem::exists(file)) throw lumen::Error(file.string(), "is there already", "choose another name");
  for (const auto& [file, text] : files) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream stream(file, std::ios::binary);
    stream << text;
    stream.close();
    if (!stream) throw lumen::Error(file.string(), "cannot be written");
    fmt::print("{}\n", file.string());
  }
}

}  // namespace

int run_new(const NewOptions& options) {
  const Installation installation = Installation::find();
  const Path templates = installation.templates();
  check(options, templates);

  Path sources;  // those that this program was built from; empty in an installation
  if (std::ifstream description(installation.build_description()); description) {
    const auto json = nlohmann::json::parse(description, nullptr, false);
    if (json.is_object()) sources = json.value("sources", std::string());
  }
  const Path folder = options.folder.empty() ? (sources.empty() ? std::filesystem::current_path() : sources) : std::filesystem::absolute(options.folder);
  const bool in_tree = std::filesystem::exists(folder / "sdk/lumen/lumen.h");

  Words words{{"kind", options.kind}, {"name", options.name}, {"Class", camel(options.name)}, {"Title", title(options.name)},
              {"test", camel(options.kind) + camel(options.name)}, {"root", installation.root.string()},
              {"include", sources.empty() ? (installation.root / "include").string()
                                          : (sources / "sdk").string() + ";" + (installation.root / "include").string()}};
  const auto text_of = [&](const char* name) { return filled(read(templates / options.kind / name), words); };
  const bool has_shader = std::filesystem::exists(templates / options.kind / "plugin.glsl");

  const Path own = in_tree ? folder / "plugins" / options.kind / options.name : folder / options.name;
  const Path shader = (in_tree ? folder : own) / "shaders" / options.kind / (options.name + ".glsl");
  std::map<Path, std::string> files{{own / (options.name + ".cpp"), text_of("plugin.cpp")}};
  if (has_shader) files[shader] = text_of("plugin.glsl");
  if (in_tree) {
    words["body"] = text_of("test.cpp");
    files[folder / "tests/plugins" / (options.kind + "_" + options.name + "_test.cpp")] = filled(read(templates / "test_header.cpp"), words);
  } else {
    files[own / "CMakeLists.txt"] = filled(read(templates / "CMakeLists.txt"), words);
    if (std::filesystem::exists(templates / options.kind / "session.json")) files[own / "session.json"] = text_of("session.json");
  }
  write(files);
  return exit_well;
}

}  // namespace lumenshop
