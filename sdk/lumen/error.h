/// The one exception of plugins and host: what is wrong, where, and what to do about it.
#pragma once

#include <stdexcept>
#include <string>

namespace lumen {

/// what(): one line for a person: "aorta.vtp:3: not a VTK XML file; expected <VTKFile>".
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
  /// `where` is a file, file:line or instance.property; `advice` may be empty.
  Error(const std::string& where, const std::string& what, const std::string& advice = {})
      : std::runtime_error(where + ": " + what + (advice.empty() ? "" : "; " + advice)) {}
};

}  // namespace lumen
