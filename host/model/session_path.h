/// Files that a session names: absolute while it is open, relative to its folder in its file.
#pragma once

#include <filesystem>

#include <lumen/value.h>

#include "model/json_value.h"

namespace lumenshop {

/// Makes a relative path absolute, from `folder`; true if it was relative. An empty one stays empty.
bool make_absolute(lumen::Path& path, const std::filesystem::path& folder);

/// Relative if it was given so, or if the file lies inside the folder; else as it is.
Json path_in_session(const lumen::Path& path, bool given_relative, const std::filesystem::path& folder);

}  // namespace lumenshop
