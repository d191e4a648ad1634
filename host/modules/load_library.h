/// Loads shared libraries, with reasons that people understand.
#pragma once

#include <filesystem>
#include <string>

namespace lumenshop {

/// Loads `file` with all symbols bound, its own kept to itself. It stays loaded. Throws lumen::Error: "NAME: undefined symbol ...".
void* load_library(const std::filesystem::path& file, const std::string& name);

/// A symbol of a loaded library; null if it exports none of that name.
const void* find_symbol(void* library, const char* name);

}  // namespace lumenshop
