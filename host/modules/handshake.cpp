#include "modules/handshake.h"

#include <array>
#include <cstring>
#include <fstream>
#include <set>

#include <sys/stat.h>

namespace lumenshop {

namespace {

using lumen::Kind;
constexpr std::array plugin_kinds{Kind::importer, Kind::exporter, Kind::filter, Kind::renderer, Kind::ambient, Kind::diffuse, Kind::specular,
                                  Kind::opacity, Kind::splitter, Kind::occlusion, Kind::transparency, Kind::compositor, Kind::interactor, Kind::editor};
constexpr std::ptrdiff_t most_types = 1024;

/// Whether liblumen on disk is another file than the one this process runs: then the process is what is out of date.
bool sdk_was_rebuilt() {
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    const std::size_t path = line.find('/');
    if (path == std::string::npos || line.find("/liblumen.so", path) == std::string::npos) continue;
    if (line.ends_with(" (deleted)")) return true;
    struct stat status {};
    unsigned long inode = 0;
    std::sscanf(line.c_str(), "%*s %*s %*s %*s %lu", &inode);
    return ::stat(line.substr(path).c_str(), &status) == 0 && status.st_ino != inode;
  }
  return false;
}

bool name_is_well_formed(std::string_view name) {
  if (name.empty() || name[0] < 'a' || name[0] > 'z') return false;
  for (const char letter : name)
    if (!(letter >= 'a' && letter <= 'z') && !(letter >= '0' && letter <= '9') && letter != '_') return false;
  return true;
}

}  // namespace

std::string abi_problem(const char* abi) {
  if (abi && std::strcmp(abi, LUMEN_ABI) == 0) return {};
  if (sdk_was_rebuilt()) return "built for a newer SDK: the host is older; restart it";
  return "built for another SDK; rebuild it";
}

std::optional<Kind> kind_of(std::string_view type) {
  const std::size_t dot = type.find('.');
  if (dot == std::string_view::npos || !name_is_well_formed(type.substr(dot + 1))) return std::nullopt;
  for (const Kind kind : plugin_kinds)
    if (lumen::name_of(kind) == type.substr(0, dot)) return kind;
  return std::nullopt;
}

void check_table(const lumen::PluginTable* table, const std::string& library) {
  if (!table) throw lumen::Error(library, "it exports no lumen_plugins", "declare its types with LUMEN_PLUGIN");
  if (const std::string problem = abi_problem(table->abi); !problem.empty()) throw lumen::Error(library, problem);
  const std::ptrdiff_t count = table->end - table->begin;
  if (!table->begin || count <= 0 || count > most_types) throw lumen::Error(library, "its table has no types");
  std::set<std::string_view> ids;
  for (const lumen::PluginType* type = table->begin; type != table->end; ++type) {
    if (!type->id || !type->create || !type->doc || !type->source) throw lumen::Error(library, "its table has holes");
    if (!kind_of(type->id)) throw lumen::Error(library, "'" + std::string(type->id) + "' is no type id", "it must be <kind>.<name> with a known kind");
    if (!ids.insert(type->id).second) throw lumen::Error(library, "the type " + std::string(type->id) + " is there twice");
  }
}

}  // namespace lumenshop
