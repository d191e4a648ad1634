/// `lumenshop check`: runs the validator over a plugin's library.
#include <fmt/format.h>

#include <lumen/error.h>

#include "command/commands.h"
#include "installation.h"
#include "modules/validator.h"
#include "process/helper.h"

namespace lumenshop {

int run_check(const CheckOptions& options) {
  if (!std::filesystem::is_regular_file(options.library)) throw lumen::Error(options.library.string(), "no such file");
  const Installation installation = Installation::find();
  Helper helper(installation.helper(), installation.workers());
  const std::vector<CheckResult> results = validate(std::filesystem::absolute(options.library), options.level, helper);
  int failures = 0;
  for (const CheckResult& result : results) {
    fmt::print("{} {:>2} {}{}\n", result.passed ? "pass" : "FAIL", result.level, result.name, result.message.empty() ? "" : ": " + result.message);
    failures += !result.passed;
  }
  if (failures == 0) return exit_well;
  fmt::print(stderr, "lumenshop: {}: {} of {} checks failed\n", options.library.string(), failures, results.size());
  return exit_failed;
}

}  // namespace lumenshop
