/// What compiler, linker and CMake say, as problems with a place.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include <lumen/editor.h>

namespace lumenshop {

/// Errors and warnings of a build's output, each once, in order; relative files are in `folder`. Notes are left out.
std::vector<lumen::Problem> parse_compiler_messages(std::string_view output, const std::filesystem::path& folder);

}  // namespace lumenshop
