/// "Did you mean": the name that is closest to a mistyped one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lumenshop {

/// The nearest of `names` by edit distance (swapped neighbors count once); empty if none is near: at most a third of the
/// letters, and 3, may differ.
std::string nearest_name(std::string_view name, const std::vector<std::string>& names);

/// "did you mean 'radius'?" or, if none is near, empty.
std::string suggestion(std::string_view name, const std::vector<std::string>& names);

}  // namespace lumenshop
