#include "modules/validator.h"

#include <algorithm>
#include <functional>

#include <nlohmann/json.hpp>

#include <lumen/error.h>

#include "modules/elf_file.h"
#include "process/helper.h"

namespace lumenshop {

namespace {

class Report {
 public:
  /// Runs one check; what it throws is why it failed.
  void check(int level, const std::string& name, const std::function<void()>& work) {
    try {
      work();
      results_.push_back({level, name, true, {}});
    } catch (const std::exception& error) {
      results_.push_back({level, name, false, error.what()});
    }
  }
  bool clean() const { return std::all_of(results_.begin(), results_.end(), [](const CheckResult& result) { return result.passed; }); }
  std::vector<CheckResult> take() { return std::move(results_); }

 private:
  std::vector<CheckResult> results_;
};

void check_exports(const ElfFile& elf, const std::string& name) {
  std::string others;
  bool table = false;
  for (const std::string& symbol : elf.exports()) {
    if (symbol == "lumen_plugins") table = true;
    else others += (others.empty() ? "" : ", ") + symbol;
  }
  if (!table) throw lumen::Error(name, "it exports no lumen_plugins", "declare its types with LUMEN_PLUGIN");
  if (!others.empty()) throw lumen::Error(name, "it exports " + others, "link it with the version script plugin.map");
}

/// All complaints of a probe about one thing, as one reason.
void check_complaints(const nlohmann::json& description) {
  std::string text;
  for (const std::string complaint : description.at("complaints"))
    text += (text.empty() ? "" : "; ") + complaint;
  if (!text.empty()) throw lumen::Error(text);
}

void check_file(const std::filesystem::path& library, Helper& helper, Report& report) {
  const std::string name = library.filename().string();
  std::unique_ptr<ElfFile> elf;
  report.check(1, "complete file", [&] { elf = std::make_unique<ElfFile>(library); });
  if (!elf) return;
  report.check(1, "exports", [&] { check_exports(*elf, name); });
  report.check(1, "position independent", [&] {
    if (elf->relocates_text()) throw lumen::Error(name, "loading it changes its code", "compile it with -fPIC");
  });
  report.check(1, "loads", [&] { helper.probe(library, 1); });
}

}  // namespace

std::vector<CheckResult> validate(const std::filesystem::path& library, int level, Helper& helper) {
  Report report;
  check_file(library, helper, report);
  nlohmann::json description;
  if (level >= 2 && report.clean()) {
    report.check(2, "handshake and ids", [&] { description = nlohmann::json::parse(helper.probe(library, 2)); });
    if (report.clean()) report.check(2, "docs", [&] { check_complaints(description); });
  }
  if (level >= 3 && report.clean()) {
    report.check(3, "create and destroy", [&] { description = nlohmann::json::parse(helper.probe(library, 3)); });
    if (report.clean()) report.check(3, "properties", [&] { check_complaints(description); });
  }
  return report.take();
}

}  // namespace lumenshop
