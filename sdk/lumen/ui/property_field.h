/// The control of a property, whatever its type.
#pragma once

#include <string>

#include <lumen/editor.h>
#include <lumen/ui/edit.h>
#include <lumen/ui/number_field.h>

namespace lumen::ui {

/// Shows and edits `value`, a copy of the property's. `width` in pixels.
Edit property_field(Workbench& workbench, const PropertyState& state, Value& value, float width);

/// Colors have no fixed range: 0..1 where the property names none.
NumberRange range_of_color(const PropertySpec& spec);

}  // namespace lumen::ui
