#include "model/session_path.h"

#include <nlohmann/json.hpp>

namespace lumenshop {

bool make_absolute(lumen::Path& path, const std::filesystem::path& folder) {
  const std::filesystem::path file(path.file);
  if (file.empty() || file.is_absolute()) return false;
  path.file = (folder / file).lexically_normal().string();
  return true;
}

Json path_in_session(const lumen::Path& path, bool given_relative, const std::filesystem::path& folder) {
  const std::filesystem::path file(path.file);
  if (!file.is_absolute()) return path.file;
  const auto relative = file.lexically_normal().lexically_relative(folder.lexically_normal());
  const bool inside = !relative.empty() && *relative.begin() != "..";
  return !relative.empty() && (inside || given_relative) ? relative.generic_string() : path.file;
}

}  // namespace lumenshop
