/// What went wrong while a command ran on: it does what it can, then says once what it could not.
#pragma once

#include <string>
#include <vector>

#include <lumen/editor.h>

namespace lumenshop {

class Findings {
 public:
  /// A failure that concerns the result. The same text counts once.
  void add(const std::string& message);
  /// Errors become failures, warnings remarks, notes are left out.
  void add(const std::vector<lumen::Problem>& problems);
  bool empty() const { return failures_.empty(); }
  /// One message: the failures, a line each, after them the remarks. Empty if there is neither.
  std::string text() const;

 private:
  std::vector<std::string> failures_, remarks_;
};

/// "file:line:column: instance: message", as far as it is known.
std::string describe(const lumen::Problem& problem);

}  // namespace lumenshop
