/// References to instances, and what data a property holds.
#pragma once

#include <string>
#include <vector>

#include <lumen/editor.h>
#include <lumen/ui/edit.h>
#include <lumen/ui/number_field.h>

namespace lumen::ui {

/// The instances that fit `accepts`: a kind's name, "camera", "light", or empty for all but views.
std::vector<InstanceState> candidates(const Workbench& workbench, const std::string& accepts);

/// A chip with the id; a click opens a list to choose from, of instances and of types to make one of (Edit::new_type).
Edit reference_field(Workbench& workbench, const char* id, std::string& reference, const std::string& accepts, float width, const FieldStyle& style = {});

/// Chips in order: up, down, the eye that enables, remove; and a list to add from.
Edit references_field(Workbench& workbench, const char* id, std::vector<std::string>& references, const std::string& accepts, float width,
                      const FieldStyle& style = {});

/// A chip that says what data is there. Shows only.
void data_chip(const PropertyState& state, float width);

}  // namespace lumen::ui
