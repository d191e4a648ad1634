#include "modules/load_library.h"

#include <dlfcn.h>

#include <lumen/error.h>

namespace lumenshop {

void* load_library(const std::filesystem::path& file, const std::string& name) {
  if (void* const library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL)) return library;
  const char* const reason = ::dlerror();
  std::string text = reason ? reason : "it cannot be loaded";
  // The loader names the file, which may be a private copy.
  if (const std::string path = file.string() + ": "; text.starts_with(path)) text.erase(0, path.size());
  throw lumen::Error(name, text);
}

const void* find_symbol(void* library, const char* name) { return ::dlsym(library, name); }

}  // namespace lumenshop
