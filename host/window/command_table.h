/// The one table of commands: it feeds menus, keys and help.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace lumenshop {

struct Command {
  std::string id;                      ///< "session.save"
  std::string menu;                    ///< "File"; empty = in no menu
  std::string title;                   ///< "Save"
  std::string keys = {};               ///< "Ctrl+S", "F12", "Del"; empty = none
  std::function<void()> run;
  std::function<bool()> enabled = {};  ///< empty = always
  std::function<bool()> checked = {};  ///< for switches
  bool separated = false;              ///< a line stands before it in its menu
};

class CommandTable {
 public:
  /// The id and the keys must be free: a clash is a mistake of the program and throws std::logic_error.
  void add(Command command);
  const std::vector<Command>& all() const { return commands_; }
  const Command* find(std::string_view id) const;
  /// Runs it if it exists and is enabled. True if it ran.
  bool run(std::string_view id) const;
  /// Runs what the chord means. While `typing`, chords without Ctrl are text, function keys excepted.
  bool press(const std::string& key, bool control, bool shift, bool typing) const;

  /// "Ctrl+Shift+Z" in this order of modifiers.
  static std::string chord(const std::string& key, bool control, bool shift);

 private:
  std::vector<Command> commands_;
};

}  // namespace lumenshop
