#include "command/findings.h"

#include <algorithm>

namespace lumenshop {
namespace {

void add_once(std::vector<std::string>& texts, const std::string& text) {
  if (std::find(texts.begin(), texts.end(), text) == texts.end()) texts.push_back(text);
}

}  // namespace

std::string describe(const lumen::Problem& problem) {
  std::string text;
  if (!problem.file.empty()) {
    text = problem.file;
    if (problem.line > 0) text += ":" + std::to_string(problem.line);
    if (problem.column > 0) text += ":" + std::to_string(problem.column);
    text += ": ";
  }
  // Messages made from lumen::Error often begin with the place already.
  if (!problem.instance.empty() && !problem.message.starts_with(problem.instance)) text += problem.instance + ": ";
  return text + problem.message;
}

void Findings::add(const std::string& message) { add_once(failures_, message); }

void Findings::add(const std::vector<lumen::Problem>& problems) {
  for (const lumen::Problem& problem : problems) {
    if (problem.severity == lumen::Severity::error) add_once(failures_, describe(problem));
    if (problem.severity == lumen::Severity::warning) add_once(remarks_, "warning: " + describe(problem));
  }
}

std::string Findings::text() const {
  std::string text;
  for (const auto* texts : {&failures_, &remarks_})
    for (const std::string& line : *texts) text += (text.empty() ? "lumenshop: " : "  ") + line + "\n";
  return text;
}

}  // namespace lumenshop
