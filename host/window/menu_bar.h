/// The bar at the top: menus from the command table, the session's title in the middle.
#pragma once

#include <string>

#include "window/command_table.h"
#include "window/layout.h"

namespace lumenshop {

void draw_menu_bar(const Rectangle& place, const CommandTable& commands, const std::string& title, bool modified);

/// The entries of one menu, also for context menus.
void draw_menu_entries(const CommandTable& commands, const std::string& menu);

}  // namespace lumenshop
