/// Loads a plugin library and tries it, in a process that may die of it.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace lumenshop {

/// Level 1 loads it, 2 checks its table, 3 creates and destroys each type 100 times. `stage` is told what comes next.
/// Returns JSON: {"types": [{"id", "doc", "source", "properties": [...]}], "complaints": ["type.property: what"]}.
/// Throws lumen::Error, or what a plugin throws.
std::string probe_library(const std::filesystem::path& library, int level, const std::function<void(const std::string&)>& stage);

}  // namespace lumenshop
