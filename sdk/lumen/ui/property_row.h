/// A property as a row: mark, label, field; its tooltip, menu and keys; why it has no effect, or what is wrong.
#pragma once

#include <string>

#include <lumen/editor.h>
#include <lumen/ui/icons.h>

namespace lumen::ui {

/// Which mark stands before a property, and so what its state is.
Icon mark_of(const PropertyState& state);

/// "diffuse_color" -> "diffuse color".
std::string label_of(const std::string& property);

/// As wide as the window's content. The field's place is recorded under "instance.property".
void property_row(Workbench& workbench, const std::string& instance, const PropertyState& state);

}  // namespace lumen::ui
