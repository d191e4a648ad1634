#include "installation.h"

#include <cstdlib>

#include <pwd.h>
#include <unistd.h>

#include <lumen/error.h>

namespace lumenshop {

namespace {

/// $VARIABLE/lumenshop, else <home>/FALLBACK/lumenshop. XDG wants relative values ignored.
std::filesystem::path user_folder(const char* variable, const char* fallback) {
  if (const char* const value = std::getenv(variable); value && value[0] == '/') return std::filesystem::path(value) / "lumenshop";
  const char* home = std::getenv("HOME");
  if (!home || home[0] != '/') {
    const passwd* const entry = ::getpwuid(::getuid());
    home = entry ? entry->pw_dir : "/";
  }
  return std::filesystem::path(home) / fallback / "lumenshop";
}

}  // namespace

Installation Installation::find() {
  std::error_code error;
  const std::filesystem::path executable = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) throw lumen::Error("/proc/self/exe", "the program does not find itself: " + error.message(), "mount /proc");
  return {executable.parent_path().parent_path()};
}

std::filesystem::path Installation::user_plugins() { return user_folder("XDG_DATA_HOME", ".local/share") / "plugins"; }

std::filesystem::path Installation::user_gallery() { return user_folder("XDG_DATA_HOME", ".local/share") / "gallery"; }

std::filesystem::path Installation::user_config() { return user_folder("XDG_CONFIG_HOME", ".config"); }

}  // namespace lumenshop
