#include "modules/compiler_messages.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>

namespace lumenshop {

namespace {

using lumen::Problem;
using lumen::Severity;

/// The text without terminal colors.
std::string plain(std::string_view line) {
  std::string text;
  for (std::size_t at = 0; at < line.size(); ++at) {
    if (line[at] != '\x1b') {
      text += line[at];
      continue;
    }
    while (at + 1 < line.size() && !(line[at] >= 'A' && line[at] <= 'Z') && !(line[at] >= 'a' && line[at] <= 'z')) ++at;
  }
  if (!text.empty() && text.back() == '\r') text.pop_back();
  return text;
}

/// The number at the end of `text` after a colon, which are taken off; nothing if there is none.
std::optional<int> take_number(std::string_view& text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string_view::npos || colon + 1 == text.size()) return std::nullopt;
  int number = 0;
  const char* const end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data() + colon + 1, end, number);
  if (error != std::errc() || stopped != end || number < 0) return std::nullopt;
  text = text.substr(0, colon);
  return number;
}

struct Word {
  std::string_view text;
  Severity severity;
};
constexpr Word words[] = {{": fatal error: ", Severity::error}, {": error: ", Severity::error}, {": warning: ", Severity::warning}};

/// "FILE:LINE:COLUMN: error: TEXT", with or without column; "mold: error: TEXT" and the like name no file.
std::optional<Problem> compiler_message(std::string_view line, const std::filesystem::path& folder) {
  for (const Word& word : words) {
    const std::size_t at = line.find(word.text);
    if (at == std::string_view::npos) continue;
    Problem problem;
    problem.severity = word.severity;
    problem.message = line.substr(at + word.text.size());
    std::string_view place = line.substr(0, at);
    const std::optional<int> last = take_number(place);
    if (last) {
      const std::optional<int> first = take_number(place);
      problem.line = first.value_or(*last);
      problem.column = first ? *last : 0;
      problem.file = (folder / place).lexically_normal().string();
    } else if (place.find(' ') != std::string_view::npos) {
      continue;  // a sentence, not a program's name
    } else {
      problem.message = std::string(place) + ": " + problem.message;
    }
    return problem;
  }
  return std::nullopt;
}

/// "CMake Error at FILE:LINE (command):"; its text is in the lines below.
std::optional<Problem> cmake_message(std::string_view line, const std::filesystem::path& folder) {
  constexpr std::string_view begin = "CMake Error at ";
  if (!line.starts_with(begin)) return std::nullopt;
  std::string_view place = line.substr(begin.size());
  place = place.substr(0, place.find(' '));
  if (place.ends_with(':')) place.remove_suffix(1);
  Problem problem;
  problem.line = take_number(place).value_or(0);
  problem.file = (folder / place).lexically_normal().string();
  return problem;
}

}  // namespace

std::vector<Problem> parse_compiler_messages(std::string_view output, const std::filesystem::path& folder) {
  std::vector<Problem> problems;
  const auto add = [&](const Problem& problem) {
    if (std::find(problems.begin(), problems.end(), problem) == problems.end()) problems.push_back(problem);
  };
  std::optional<Problem> open;  // of CMake, until its text comes
  while (!output.empty()) {
    const std::size_t end = std::min(output.find('\n'), output.size());
    const std::string line = plain(output.substr(0, end));
    output.remove_prefix(std::min(end + 1, output.size()));
    if (open) {
      const std::size_t text = line.find_first_not_of(' ');
      if (text == std::string::npos) continue;
      open->message = line.substr(text);
      add(*open);
      open.reset();
    } else if (std::optional<Problem> message = compiler_message(line, folder)) {
      add(*message);
    } else {
      open = cmake_message(line, folder);
    }
  }
  return problems;
}

}  // namespace lumenshop
