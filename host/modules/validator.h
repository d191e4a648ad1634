/// What `lumenshop check` asks of a plugin library, level by level.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lumenshop {

class Helper;

struct CheckResult {
  int level;
  std::string name;      ///< "exports"
  bool passed;
  std::string message;   ///< why it failed; empty if it passed
};

/// Level 1: the file is complete, exports lumen_plugins alone, is position independent, loads with all it needs. Level 2: same
/// SDK, well-formed ids, docs. Level 3: each type is created and destroyed 100 times, its properties are sound. All levels up
/// to `level`; the first level with a failure is the last one tried. The library is loaded in the helper process alone.
std::vector<CheckResult> validate(const std::filesystem::path& library, int level, Helper& helper);

}  // namespace lumenshop
