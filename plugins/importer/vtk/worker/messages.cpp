/// Turns VTK's many-line messages into one line for a person.
#include "messages.h"

#include <algorithm>
#include <regex>

#include <vtkLogger.h>
#include <vtkObjectFactory.h>

class Messages::Window : public vtkOutputWindow {
 public:
  static Window* New();
  vtkTypeMacro(Window, vtkOutputWindow);

  // A hostile file can cause a message per number.
  static constexpr std::size_t most = 32;
  void DisplayText(const char*) override {}
  void DisplayDebugText(const char*) override {}
  void DisplayErrorText(const char* text) override { keep(errors, text); }
  void DisplayWarningText(const char* text) override { keep(warnings, text); }
  void DisplayGenericWarningText(const char* text) override { keep(warnings, text); }

  std::vector<std::string> errors, warnings;

 private:
  static void keep(std::vector<std::string>& list, const char* text) {
    if (text && list.size() < most) list.emplace_back(text);
  }
};
vtkStandardNewMacro(Messages::Window);

namespace {

/// "ERROR: In ./IO/XML/x.cxx, line 379\nvtkXMLDataParser (0x55): Error at line 5,\n column 10 ...\n\n" -> what follows the address.
std::string essence(const std::string& text) {
  static const std::regex address(R"(\(0x[0-9a-fA-F]+\):\s*)");
  static const std::regex spaces(R"(\s+)");
  std::smatch found;
  std::string rest = text;
  if (std::regex_search(text, found, address)) rest = found.suffix();
  rest = std::regex_replace(rest, spaces, " ");
  while (!rest.empty() && (rest.back() == ' ' || rest.back() == '.')) rest.pop_back();
  constexpr std::size_t longest = 300;
  if (rest.size() > longest) rest = rest.substr(0, longest) + " ...";
  return rest;
}

}  // namespace

Messages::Messages() : previous_(vtkOutputWindow::GetInstance()) {
  vtkOutputWindow::SetInstance(window_);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}
Messages::~Messages() { vtkOutputWindow::SetInstance(previous_); }

bool Messages::failed() const { return !window_->errors.empty(); }

std::string Messages::first(const std::string& file) const {
  std::vector<std::string> list = window_->errors;
  list.insert(list.end(), window_->warnings.begin(), window_->warnings.end());
  if (list.empty()) return {};
  // That a reader failed says less than what it said before.
  const auto says_why = [](const std::string& text) { return text.find("returned failure for request") == std::string::npos; };
  const auto best = std::find_if(list.begin(), list.end(), says_why);
  if (best == list.end()) return file + ": cannot be read; it is broken or cut off";
  const std::string text = essence(*best);
  static const std::regex place(R"(^Error parsing XML in stream at line (\d+), column (\d+), byte index \d+: (.*)$)");
  std::smatch found;
  if (std::regex_match(text, found, place)) return file + ":" + found[1].str() + ":" + found[2].str() + ": " + found[3].str();
  return file + ": " + text;
}
