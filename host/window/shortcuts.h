/// The list of keys: the command table as help.
#pragma once

#include "window/command_table.h"

namespace lumenshop {

/// Opens when `open` is true, which it clears; draws while it is open.
void draw_shortcuts(const CommandTable& commands, bool& open);

}  // namespace lumenshop
