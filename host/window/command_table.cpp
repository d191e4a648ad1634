#include "window/command_table.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace lumenshop {

void CommandTable::add(Command command) {
  for (const Command& other : commands_)
    if (other.id == command.id || (!command.keys.empty() && other.keys == command.keys))
      throw std::logic_error("command " + command.id + " clashes with " + other.id);
  commands_.push_back(std::move(command));
}

const Command* CommandTable::find(std::string_view id) const {
  const auto found = std::find_if(commands_.begin(), commands_.end(), [&](const Command& command) { return command.id == id; });
  return found == commands_.end() ? nullptr : &*found;
}

bool CommandTable::run(std::string_view id) const {
  const Command* command = find(id);
  if (!command || (command->enabled && !command->enabled())) return false;
  command->run();
  return true;
}

bool CommandTable::press(const std::string& key, bool control, bool shift, bool typing) const {
  const bool is_function_key = key.size() > 1 && key[0] == 'F' && std::isdigit(static_cast<unsigned char>(key[1]));
  if (key.empty() || (typing && !is_function_key)) return false;
  const std::string wanted = chord(key, control, shift);
  const auto found = std::find_if(commands_.begin(), commands_.end(), [&](const Command& command) { return command.keys == wanted; });
  return found != commands_.end() && run(found->id);
}

std::string CommandTable::chord(const std::string& key, bool control, bool shift) {
  return std::string(control ? "Ctrl+" : "") + (shift ? "Shift+" : "") + key;
}

}  // namespace lumenshop
