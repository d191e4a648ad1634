/// What must agree between a library and the program before any of the library's code is used.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <lumen/plugin.h>

namespace lumenshop {

/// Why a library built for the SDK `abi` does not fit, with what to do; empty if it fits.
std::string abi_problem(const char* abi);

/// The kind of a well-formed type id, `<kind>.<name>` with name [a-z][a-z0-9_]*; views are no plugins.
std::optional<lumen::Kind> kind_of(std::string_view type);

/// Checks ABI, ids, functions and docs of a table. Throws lumen::Error naming `library`.
void check_table(const lumen::PluginTable* table, const std::string& library);

}  // namespace lumenshop
