/// A transfer function: opacity as a curve of points over the colors.
#pragma once

#include <lumen/ui/edit.h>
#include <lumen/ui/number_field.h>

namespace lumen::ui {

/// A click adds a point, dragging moves it, Delete removes it; below: the chosen point in numbers, the range, color maps.
Edit transfer_function_field(const char* id, TransferFunction& function, float width, const FieldStyle& style = {});

}  // namespace lumen::ui
