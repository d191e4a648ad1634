/// The menu of a property's row.
#pragma once

#include <string>

#include <lumen/editor.h>

namespace lumen::ui {

/// Draws the popup "menu" of the current id scope if it is open.
void property_menu(Workbench& workbench, const std::string& path, const PropertyState& state);

/// The value as JSON, to the clipboard.
void copy_value(const Workbench& workbench, const PropertyState& state);
/// Takes JSON, or what a person would write (16 numbers, a hex color, plain text), from the clipboard.
void paste_value(Workbench& workbench, const std::string& path, const PropertyState& state);

}  // namespace lumen::ui
